// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell.h>

#include <string>
#include <vector>

namespace slalom {

/// A metric on the scenarios in which every run of every method has a value, such as those that all
/// methods solved: unlike means over all runs with a value, means over these are comparable.
struct CommonScenarios {
  Column column;
  std::size_t scenarios = 0, left_out = 0;
  std::vector<Cell> cells;                     ///< one per method of the results
  std::vector<std::vector<std::size_t>> runs;  ///< parallel: those of the cell
};

/// Finds the scenarios of a metric of the table: true for each that is common.
std::vector<bool> find_common_scenarios(const ResultTable& table, const ValueColumn& metric);

/// Makes those of a metric of the table.
CommonScenarios make_common_scenarios(const ResultTable& table, const Column& column,
                                      const AnalysisOptions& options);

/// Finds the common scenarios of the metrics of which a method has values of its survivors only
/// (is_survivors_only()), except measured times; none with a single method. Throws Error (Usage)
/// for an unknown metric.
std::vector<CommonScenarios> build_common_scenarios(const ResultTable& table,
                                                    const std::vector<std::string>& metrics,
                                                    const AnalysisOptions& options);

/// "optimality on the 12 scenarios that all 3 methods solved": solved means that each run has a
/// value.
std::string title_of(const CommonScenarios& common);

}  // namespace slalom
