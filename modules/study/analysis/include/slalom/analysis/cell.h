// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell_sums.h>
#include <slalom/core/error.h>
#include <slalom/results/result_table.h>
#include <slalom/statistics/statistics.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Options of table computation. Results are deterministic in the options and the input.
struct AnalysisOptions {
  double confidence = 0.95;  ///< of intervals, in (0, 1)
  std::uint64_t seed = 1;    ///< of resampled orders (rank_stability(), sim2real)
  bool run_ids = true;       ///< store the run ids of each row; expensive for millions of runs
  bool medians = true;       ///< in tables: medians with intervals, and interquartile means
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
  std::optional<Interval> interval;         ///< of the estimate
  std::string interval_na;                  ///< why the estimate has none
  std::optional<Interval> median_interval;  ///< see states_median()
};

/// Whether the median is what can be stated with an interval: values without bounds have no valid
/// interval of their mean, whatever the sample (Bahadur and Savage 1956).
bool states_median(const QuantityInfo& info);

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

/// A cell from its sums, without median and interquartile mean. The interval of a rate is
/// rate_interval(), of a score hurdle_interval(), of other bounded values gaffke_interval().
/// `rank_of`: see CellSums::groups().
Cell make_cell(const CellSums& sums, std::size_t runs, std::size_t failures, const Column& column,
               const AnalysisOptions& options,
               const std::function<std::size_t(std::uint32_t)>& rank_of = nullptr);

/// The values of those of the runs that have one.
std::vector<double> numbers_of(const ValueColumn& values, const std::vector<std::size_t>& runs);
/// Adds median, interquartile mean and, if it states_median(), the interval of the median over
/// `runs` of the table; nothing if no run has a value.
void add_medians(Cell& cell, const ResultTable& table, const std::vector<std::size_t>& runs,
                 const ValueColumn& values, double confidence);

/// Summarizes `values` over `runs` (indexes into `table`).
Cell make_cell(const ResultTable& table, const std::vector<std::size_t>& runs,
               const ValueColumn& values, const AnalysisOptions& options);

}  // namespace slalom
