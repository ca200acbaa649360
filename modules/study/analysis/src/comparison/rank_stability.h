// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/statistics/rank_statistics.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// How well the order of the methods in one result set is kept in another.
struct RankStability {
  std::size_t scenarios = 0;         ///< in which every method has a value in both
  std::optional<double> tau;         ///< Kendall's tau-b of the methods' means; none if undefined
  std::optional<Interval> interval;  ///< percentile bootstrap over scenarios
  std::optional<NoiseCeiling> ceiling;  ///< of tau, by the same resamples
};

/// Compares the order of the methods that both results contain, by their means over the common
/// scenarios (mean over the runs of a scenario). tau = 1: the same order, -1: the opposite one.
/// There is no value for fewer than two methods or no common scenario, and no interval for fewer
/// than two scenarios. The ceiling is tau if methods of equal rank were the same one. Resamples
/// without a defined tau (all methods tied) are left out. `label` seeds the bootstrap. Throws Error
/// (Usage) for an unknown metric.
RankStability rank_stability(const ResultTable& first, const ResultTable& other,
                             const std::string& metric, const AnalysisOptions& options,
                             const std::string& label);

}  // namespace slalom
