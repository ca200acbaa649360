// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace slalom {

/// The folder for small files of tests that are written in transactions: in memory if the system
/// has such a folder, because each transaction would wait for the disk.
inline std::filesystem::path memory_folder() {
  const std::filesystem::path memory = "/dev/shm";
  constexpr std::uintmax_t kMinSpace = 512U << 20U;  // bytes
  std::error_code error;
  const auto space = std::filesystem::space(memory, error);
  if (!error && space.available >= kMinSpace && access(memory.c_str(), W_OK) == 0) return memory;
  return std::filesystem::temp_directory_path();
}

}  // namespace slalom
