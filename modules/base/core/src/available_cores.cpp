// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/available_cores.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sched.h>
#include <thread>

namespace slalom {
namespace {

/// The quota in a folder of cgroup2, whose cpu.max is "QUOTA PERIOD" in microseconds or "max
/// PERIOD".
std::optional<int> read_quota(const std::filesystem::path& folder) {
  constexpr double kMaxCores = 1e6;
  double quota = 0, period = 0;
  std::ifstream file(folder / "cpu.max");
  if (!(file >> quota >> period) || !(quota > 0) || !(period > 0)) return std::nullopt;
  return static_cast<int>(std::ceil(std::min(quota / period, kMaxCores)));
}

/// The control group of this process: the line "0::/GROUP".
std::string own_group() {
  std::ifstream file("/proc/self/cgroup");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("0::", 0) == 0) return line.substr(3);
  return "/";
}

/// std::thread::hardware_concurrency() does not regard the affinity with all versions of glibc.
int cores_of_affinity() {
  cpu_set_t cores;
  if (sched_getaffinity(0, sizeof(cores), &cores) == 0) return CPU_COUNT(&cores);
  return static_cast<int>(std::thread::hardware_concurrency());  // more cores than the set can hold
}

}  // namespace

std::optional<int> quota_of_group(const std::string& root, const std::string& group) {
  std::filesystem::path folder = root;
  std::optional<int> smallest = read_quota(folder);
  for (const std::filesystem::path& part : std::filesystem::path(group).relative_path()) {
    folder /= part;
    const std::optional<int> quota = read_quota(folder);
    if (quota) smallest = std::min(smallest.value_or(*quota), *quota);
  }
  return smallest;
}

int available_cores() {
  const int cores = cores_of_affinity();
  return std::max(1,
                  std::min(cores, quota_of_group("/sys/fs/cgroup", own_group()).value_or(cores)));
}

int worker_count(int wanted) {
  return wanted == 0 ? available_cores() : wanted;
}

}  // namespace slalom
