#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/analysis/survival.h>

#include <string>
#include <vector>

namespace slalom {

/// How many of a method's runs had reached the goal by when.
struct CompletionCurve {
  std::string method;
  std::size_t n = 0;  ///< runs that say something of the method
  std::size_t successes = 0;
  std::size_t unknown_end = 0;  ///< failed runs of unknown duration: out of Kaplan and Meier's
  /// Share that has arrived (Aalen and Johansen): failures compete with arriving, so that the curve
  /// ends at the success rate. Read this one.
  std::vector<CurvePoint> incidence;
  /// One less Kaplan and Meier's share that has not arrived, failures counted as censored: what
  /// arriving would look like had failed runs been as quick as the others. At least `incidence`.
  std::vector<CurvePoint> kaplan_meier;
};

/// Curves of every method over the metric `time` ("time_to_goal"), which is there for runs that
/// arrived. A failed run ended after path_length / mean_speed, where both are there.
std::vector<CompletionCurve> build_completion(const RunColumns& table, const std::string& time);

}  // namespace slalom
