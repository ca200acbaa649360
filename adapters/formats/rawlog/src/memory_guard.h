// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <sys/resource.h>

namespace slalom {

/// Limits the memory of the process during its lifetime to `allowance` more bytes. MRPT's readers
/// trust the counts in a file and allocate memory before they read: with this guard a wrong count
/// causes std::bad_alloc, independent of the machine.
class MemoryGuard {
 public:
  explicit MemoryGuard(std::size_t allowance);
  ~MemoryGuard();
  MemoryGuard(const MemoryGuard&) = delete;
  MemoryGuard& operator=(const MemoryGuard&) = delete;

 private:
  bool active_ = false;
  rlimit previous_{};
};

}  // namespace slalom
