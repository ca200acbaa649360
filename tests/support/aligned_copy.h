// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/shared_array.h>

#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <string>

namespace slalom {

/// A copy of the bytes in memory that is aligned like a mapping of another process's memory.
inline SharedArray<std::byte> aligned_copy(const std::string& bytes) {
  constexpr std::align_val_t kPage{4096};
  auto* memory = static_cast<std::byte*>(operator new(bytes.size() + 1, kPage));
  std::memcpy(memory, bytes.data(), bytes.size());
  const auto release = [](const std::byte* data) {
    operator delete (const_cast<std::byte*>(data), std::align_val_t{4096});
  };
  return {std::shared_ptr<const std::byte>(memory, release), bytes.size()};
}

}  // namespace slalom
