// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell_sums.h>
#include <slalom/analysis/statistics.h>
#include <slalom/core/error.h>
#include <slalom/results/result_table.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Options of table computation. Results are deterministic in the options and the input.
struct AnalysisOptions {
  double confidence = 0.95;  ///< of intervals, in (0, 1)
  std::uint64_t seed = 1;    ///< of the bootstrap
  bool run_ids = true;       ///< store the run ids of each row; expensive for millions of runs
  bool medians = true;       ///< in cross tables: medians and interquartile means
};

/// Throws Error (Usage) if the confidence is not in (0, 1).
void require_valid(const AnalysisOptions& options);

/// A column of a table.
struct Column {
  QuantityInfo info;
  bool wall_clock = false;  ///< measured time: not reproducible
};

/// Statistics of one column over a group of runs.
struct Cell {
  std::size_t n = 0;                      ///< runs in the group
  std::size_t available = 0;              ///< runs with a value
  std::size_t failures = 0;               ///< runs with an outcome that is a failure of the method
  std::map<std::string, std::size_t> na;  ///< runs without a value, by reason
  std::optional<double> estimate;         ///< mean or rate
  std::optional<double> deviation;        ///< sample standard deviation
  std::optional<double> median;
  std::optional<double> interquartile_mean;
  std::optional<Interval> interval;  ///< of the estimate
};

/// More than a tenth of the runs have no value: the mean describes the others only, such as the
/// runs that succeeded, and is not comparable with that of a method with other missing runs.
bool is_survivors_only(std::size_t runs, std::size_t available);

/// The columns with these ids: metrics of the table, "success" (derived from the outcome if it was
/// not recorded as a metric), or wall-clock measurements such as "cycle_time_mean". Throws Error
/// (Usage) with the nearest name for an unknown id.
std::vector<Column> resolve_columns(const ResultTable& table, const std::vector<std::string>& ids);

/// Throws Error (Usage) at `where` if a foreign table has this column, but not as a metric.
void require_readable(const ResultTable& table, const std::string& where, const std::string& id);

/// Error (Usage) that there is no such metric, with the nearest name.
Error unknown_metric(const std::string& id, const std::vector<std::string>& known);

/// A cell from its sums, without median and interquartile mean. `rank_of`: see CellSums::groups().
Cell make_cell(const CellSums& sums, std::size_t runs, std::size_t failures, const Column& column,
               const AnalysisOptions& options, const std::string& label,
               const std::function<std::size_t(std::uint32_t)>& rank_of = nullptr);

/// The values of those of the runs that have one.
std::vector<double> numbers_of(const ValueColumn& values, const std::vector<std::size_t>& runs);
void add_medians(Cell& cell, std::vector<double> values);  ///< both, if there are values

/// Summarizes `values` over `runs` (indexes into `table`). `label` identifies the cell and seeds
/// the bootstrap, so that a cell does not depend on which other cells are computed.
Cell make_cell(const ResultTable& table, const std::vector<std::size_t>& runs,
               const ValueColumn& values, const AnalysisOptions& options, const std::string& label);

}  // namespace slalom
