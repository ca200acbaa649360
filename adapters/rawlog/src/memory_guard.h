#pragma once

#include <cstddef>
#include <sys/resource.h>

namespace slalom {

/// While it lives the process may take only `allowance` more bytes of memory. MRPT's readers
/// believe the counts in a file and take memory before they read: with this a wrong count ends as
/// std::bad_alloc, whatever the machine would give.
class MemoryGuard {
 public:
  explicit MemoryGuard(std::size_t allowance);
  ~MemoryGuard();
  MemoryGuard(const MemoryGuard&) = delete;
  MemoryGuard& operator=(const MemoryGuard&) = delete;

 private:
  bool active_ = false;
  rlimit before_{};
};

}  // namespace slalom
