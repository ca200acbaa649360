// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/metrics/cycle_time.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

/// The smallest value such that at least `fraction` of all values are at or below it.
double nearest_rank(const std::vector<double>& sorted, double fraction) {
  const double rank = std::ceil(fraction * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

}  // namespace

std::map<std::string, double> cycle_time_statistics(const std::vector<double>& seconds,
                                                    double deadline) {
  if (seconds.empty()) return {};
  std::vector<double> ms(seconds.size());
  std::transform(seconds.begin(), seconds.end(), ms.begin(), [](double s) { return s * 1e3; });
  std::sort(ms.begin(), ms.end());
  const auto late =
      std::count_if(seconds.begin(), seconds.end(), [deadline](double s) { return s > deadline; });
  const double sum = std::accumulate(ms.begin(), ms.end(), 0.0);
  return {{"cycle_time_mean", sum / static_cast<double>(ms.size())},
          {"cycle_time_p50", nearest_rank(ms, 0.50)},
          {"cycle_time_p95", nearest_rank(ms, 0.95)},
          {"cycle_time_p99", nearest_rank(ms, 0.99)},
          {"cycle_time_max", ms.back()},
          {"deadline_miss_ratio", static_cast<double>(late) / static_cast<double>(ms.size())}};
}

}  // namespace slalom
