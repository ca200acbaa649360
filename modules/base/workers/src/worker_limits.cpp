// SPDX-License-Identifier: BSD-3-Clause
#include "worker_limits.h"

#include <slalom/workers/pool_options.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace slalom {
namespace {

#if defined(SLALOM_SANITIZE)
constexpr bool kAddressSanitizer = true;
#else
constexpr bool kAddressSanitizer = false;
#endif

/// The size of the address space in use, in bytes.
std::size_t address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Sets the soft limit only: it can be raised again for the next work item.
void set_soft_limit(__rlimit_resource_t resource, rlim_t value) {
  rlimit limit{};
  getrlimit(resource, &limit);
  limit.rlim_cur = limit.rlim_max == RLIM_INFINITY ? value : std::min(value, limit.rlim_max);
  setrlimit(resource, &limit);
}

}  // namespace

void limit_memory(std::size_t bytes) {
  if (bytes > 0 && !kAddressSanitizer) set_soft_limit(RLIMIT_AS, address_space() + bytes);
}

std::uint64_t count_memory_kills() {
  std::ifstream counters("/proc/vmstat");
  std::uint64_t value = 0;
  for (std::string name; counters >> name >> value;)
    if (name == "oom_kill") return value;
  return 0;
}

void limit_cpu_time(double seconds) {
  if (seconds > 0)
    set_soft_limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(cpu_seconds() + seconds)));
}

}  // namespace slalom
