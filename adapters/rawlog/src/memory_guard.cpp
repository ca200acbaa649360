#include "memory_guard.h"

#include <fstream>
#include <unistd.h>

namespace slalom {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kLimitsHold = false;  // its shadow memory counts as taken
#else
constexpr bool kLimitsHold = true;
#endif

/// Bytes of data and stack that the process has taken; 0 where the system does not say.
std::size_t taken_bytes() {
  std::ifstream pages("/proc/self/statm");
  std::size_t size = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
  pages >> size >> resident >> shared >> text >> library >> data;
  return pages ? data * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace

MemoryGuard::MemoryGuard(std::size_t allowance) {
  const std::size_t taken = taken_bytes();
  if (!kLimitsHold || taken == 0 || getrlimit(RLIMIT_DATA, &before_) != 0) return;
  rlimit limit = before_;
  if (limit.rlim_cur <= taken + allowance) return;
  limit.rlim_cur = taken + allowance;
  active_ = setrlimit(RLIMIT_DATA, &limit) == 0;
}

MemoryGuard::~MemoryGuard() {
  if (active_) setrlimit(RLIMIT_DATA, &before_);
}

}  // namespace slalom
