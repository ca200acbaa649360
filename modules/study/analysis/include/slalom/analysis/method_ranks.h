// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/statistics/friedman.h>

#include <string>
#include <vector>

namespace slalom {

/// All methods ranked in one metric: the data of a critical-difference diagram.
struct MethodRanks {
  Column column;
  std::vector<std::string> methods;  ///< in the order of test.mean_ranks
  FriedmanTest test;
  std::size_t left_out = 0;       ///< scenarios in which some methods have a value, but not all
  std::size_t without_value = 0;  ///< scenarios in which none has
  double alpha = 0.05;

  std::size_t all_scenarios() const { return test.scenarios + left_out + without_value; }
};

/// "2 in which not every method has a value, 3 in which none has"; empty if none is left out.
std::string left_out_text(const MethodRanks& ranks);

/// Ranks the means over a scenario's runs within scenarios. Throws Error (Usage) if there are fewer
/// than two methods with two scenarios in common, or the metric has no direction.
MethodRanks build_method_ranks(const ResultTable& table, const std::string& metric,
                               const AnalysisOptions& options);

}  // namespace slalom
