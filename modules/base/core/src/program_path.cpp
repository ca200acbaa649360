// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/program_path.h>

#include <filesystem>
#include <system_error>

namespace slalom {

std::string program_path() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

std::string program_folder() {
  return std::filesystem::path(program_path()).parent_path().string();
}

std::string shipped_file(const std::string& name) {
  const auto path = std::filesystem::path(program_folder()) / "../share/slalom" / name;
  return path.lexically_normal().string();
}

}  // namespace slalom
