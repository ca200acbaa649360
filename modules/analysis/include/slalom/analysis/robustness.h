#pragma once

#include <slalom/analysis/paired_comparison.h>

#include <string>
#include <vector>

namespace slalom {

/// A method at one value of the parameter.
struct RobustnessPoint {
  double parameter = 0;
  std::string source;             ///< the result file
  std::size_t result = 0;         ///< its place in the sweep
  std::vector<std::size_t> runs;  ///< places in that result
  Cell cell;
  std::optional<PairedComparison> change;  ///< against the first value, on the same scenarios
};

struct RobustnessCurve {
  std::string method;
  Column column;
  std::vector<RobustnessPoint> points;  ///< by increasing parameter
};

struct RobustnessTable {
  std::string parameter;  ///< "sensor.noise_sigma"
  std::vector<RobustnessCurve> curves;
  double confidence = 0.95;
};

struct RobustnessOptions {
  ComparisonOptions comparison;
  std::vector<double> values;      ///< one a file; empty: as each campaign's .ini says
  bool allow_differences = false;  ///< campaigns may differ in more than the parameter
};

/// How each metric of each method changes over a swept parameter: one result set for each value.
/// Throws Error (Usage) where a value is not known, or comes twice, or the campaigns differ in
/// other settings too.
RobustnessTable build_robustness(const std::vector<RunColumns>& sweep, const std::string& parameter,
                                 const std::vector<std::string>& metrics,
                                 const RobustnessOptions& options);

}  // namespace slalom
