#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/analysis/friedman.h>

#include <string>
#include <vector>

namespace slalom {

/// All methods ranked in one metric: what a critical-difference diagram shows.
struct MethodRanks {
  Column column;
  std::vector<std::string> methods;  ///< in the order of test.mean_ranks
  FriedmanTest test;
  std::size_t left_out = 0;  ///< scenarios in which not every method has a value
  double alpha = 0.05;
};

/// Means over a scenario's runs, ranked within scenarios. Throws Error (Usage) where there are not
/// two methods with two scenarios in common, or the metric has no direction.
MethodRanks build_method_ranks(const RunColumns& table, const std::string& metric,
                               const AnalysisOptions& options);

}  // namespace slalom
