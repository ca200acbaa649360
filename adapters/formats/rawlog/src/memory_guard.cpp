// SPDX-License-Identifier: BSD-3-Clause
#include "memory_guard.h"

#include <fstream>
#include <unistd.h>

namespace slalom {
namespace {

#if defined(SLALOM_SANITIZE)
constexpr bool kLimitsSupported = false;  // its shadow memory counts as used
#else
constexpr bool kLimitsSupported = true;
#endif

/// Bytes of data and stack used by the process; 0 if unknown.
std::size_t used_bytes() {
  std::ifstream pages("/proc/self/statm");
  std::size_t size = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
  pages >> size >> resident >> shared >> text >> library >> data;
  return pages ? data * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace

MemoryGuard::MemoryGuard(std::size_t allowance) {
  const std::size_t used = used_bytes();
  if (!kLimitsSupported || used == 0 || getrlimit(RLIMIT_DATA, &previous_) != 0) return;
  rlimit limit = previous_;
  if (limit.rlim_cur <= used + allowance) return;
  limit.rlim_cur = used + allowance;
  active_ = setrlimit(RLIMIT_DATA, &limit) == 0;
}

MemoryGuard::~MemoryGuard() {
  if (active_) setrlimit(RLIMIT_DATA, &previous_);
}

}  // namespace slalom
