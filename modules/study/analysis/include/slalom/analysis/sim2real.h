// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/statistics/rank_statistics.h>

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A method in reality and in simulation.
struct Sim2RealMethod {
  std::string name;
  std::size_t real_runs = 0, simulated_runs = 0;  ///< with a value
  double real = 0, simulated = 0;                 ///< means, in the unit of the metric
};

/// A figure of agreement between the two orders.
struct Agreement {
  std::optional<double> value;
  std::optional<Interval> interval;  ///< percentile bootstrap
  /// What a rank correlation would be, by the same resamples, if the method of each rank in reality
  /// were that of the same rank in simulation; none of other figures.
  std::optional<NoiseCeiling> ceiling;
  std::string reason;  ///< why there is no value
};

/// Two methods that are next to each other in the real order.
struct UndecidedOrder {
  std::string better, worse;  ///< by the real means
  /// Real runs of each method, beyond those of the one with fewer, that would decide their order
  /// if the means differ by as much as they do now; 0: there are enough. None if the means are
  /// equal.
  std::optional<std::size_t> more_runs;
};

/// Whether the order of methods in simulation is that in reality.
struct Sim2Real {
  std::string metric, unit;
  std::size_t scenarios = 0;  ///< common ones; 0: the means are over all runs of each
  double confidence = 0, power = 0;
  std::vector<Sim2RealMethod> methods;  ///< best real mean first
  Agreement spearman, kendall, pearson;
  /// Mean maximum rank violation, in the unit of the metric: for each method the largest real
  /// difference to another one with which the simulation disagrees in sign, averaged over methods
  /// (X. Li et al., "Evaluating Real-World Robot Manipulation Policies in Simulation", Conference
  /// on Robot Learning 2024, section 3). 0: the same order.
  Agreement mmrv;
  std::vector<UndecidedOrder> orders;
};

/// Compares the means of a metric over real runs with those over simulated ones. If scenarios of
/// `real` are in `simulated` (by hash or name), means are over the real runs and over the simulated
/// means of the same scenarios, and the bootstrap resamples scenarios, then real runs in them; if
/// none is, all runs count, and runs of both sides are resampled. Correlations are NA for fewer
/// than 3 methods. Throws Error (Usage) for an unknown metric, a metric without a better direction,
/// fewer than two methods, a real method or (if others are) a real scenario that is not in
/// `simulated`, and a method without a value.
Sim2Real sim2real(const ResultTable& real, const ResultTable& simulated, const std::string& metric,
                  const AnalysisOptions& options, double power = 0.8);

/// The mean maximum rank violation of means (parallel); requires at least one.
double mean_max_rank_violation(const std::vector<double>& real,
                               const std::vector<double>& simulated);

std::string render_text(const Sim2Real& comparison);
nlohmann::ordered_json sim2real_json(const Sim2Real& comparison);

}  // namespace slalom
