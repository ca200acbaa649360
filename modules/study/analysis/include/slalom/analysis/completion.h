// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/statistics/survival.h>

#include <string>
#include <vector>

namespace slalom {

/// Cumulative fraction of a method's runs that reached the goal, over time.
struct CompletionCurve {
  std::string method;
  std::size_t n = 0;  ///< runs that are informative about the method
  std::size_t successes = 0;
  std::size_t unknown_end = 0;  ///< failed runs of unknown duration, excluded from `kaplan_meier`
  std::size_t untimed = 0;      ///< runs that reached the goal at an unknown time, left out
  /// Cumulative incidence of reaching the goal (Aalen and Johansen), with failures as competing
  /// risks: the curve ends at the success rate. The recommended estimate.
  std::vector<CurvePoint> incidence;
  /// One minus the Kaplan-Meier estimate with failures as censored: the curve if failed runs had
  /// continued like the others. Never below `incidence`.
  std::vector<CurvePoint> kaplan_meier;
};

/// Curves of every method over the metric `time` ("time_to_goal") of runs with the outcome success.
/// The duration of a failed run is this time in a foreign table, else path_length / mean_speed, if
/// both are available. Throws Error (Usage) for a table without outcomes and success, and for a
/// rate as the time.
std::vector<CompletionCurve> build_completion(const ResultTable& table, const std::string& time);

}  // namespace slalom
