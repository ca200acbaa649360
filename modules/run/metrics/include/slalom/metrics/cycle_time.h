// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Statistics of a method's computation time per control cycle (wall-clock time, so not part of the
/// deterministic results): cycle_time_mean, _p50, _p95, _p99, _max in ms, quantiles by nearest
/// rank; and deadline_miss_ratio, the fraction of cycles that took longer than `deadline` seconds.
/// Empty without cycles.
std::map<std::string, double> cycle_time_statistics(const std::vector<double>& seconds,
                                                    double deadline);

}  // namespace slalom
