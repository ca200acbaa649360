// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rank_stability.h"

#include <slalom/analysis/paired_comparison.h>

#include <string>
#include <vector>

namespace slalom {

/// A method at one value of the parameter.
struct RobustnessPoint {
  double parameter = 0;
  std::string source;             ///< the result file
  std::size_t result = 0;         ///< its index in the sweep
  std::vector<std::size_t> runs;  ///< indexes into that result
  Cell cell;
  std::optional<PairedComparison> change;  ///< from the first value, on the same scenarios
};

struct RobustnessCurve {
  std::string method;
  Column column;
  std::vector<RobustnessPoint> points;  ///< by increasing parameter
};

/// The order of the methods in a metric at one value of the parameter, against the first value.
struct RobustnessOrder {
  Column column;
  double parameter = 0;
  RankStability stability;
};

struct RobustnessTable {
  std::string parameter;  ///< "sensor.noise_sigma"
  std::vector<RobustnessCurve> curves;
  /// Orders by the metrics with a direction, if there are at least two methods: metrics outermost.
  std::vector<RobustnessOrder> orders;
  double confidence = 0.95;
};

struct RobustnessOptions {
  ComparisonOptions comparison;
  std::vector<double> values;      ///< one per file; empty: from each campaign's .ini
  bool allow_differences = false;  ///< campaigns may differ in more than the parameter
};

/// Each metric of each method (or only of `method`) over a swept parameter, with one result set per
/// value; all changes are one family. Throws Error (Usage) if the method or a value is unknown, a
/// value duplicate, or the campaigns differ in other settings.
RobustnessTable build_robustness(const std::vector<ResultTable>& sweep,
                                 const std::string& parameter,
                                 const std::vector<std::string>& metrics,
                                 const RobustnessOptions& options, const std::string& method = "");

}  // namespace slalom
