#pragma once

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Statistics of a method's computing time per control cycle (wall clock, so never among
/// deterministic results): cycle_time_mean, _p50, _p95, _p99, _max in ms, quantiles as the nearest
/// rank; and deadline_miss_ratio, the share of cycles that took longer than `deadline` seconds.
/// Empty without cycles.
std::map<std::string, double> cycle_time_statistics(const std::vector<double>& seconds,
                                                    double deadline);

}  // namespace slalom
