#pragma once

#include <slalom/analysis/statistics.h>
#include <slalom/results/run_columns.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// How tables are computed; the same options and results give the same tables.
struct AnalysisOptions {
  double confidence = 0.95;  ///< of intervals, in (0, 1)
  std::uint64_t seed = 1;    ///< of the bootstrap
  bool run_ids = true;       ///< rows name their runs; of a million that takes memory and time
};

/// Throws Error (Usage) for a confidence that is none.
void require_valid(const AnalysisOptions& options);

/// What one column of a table shows.
struct Column {
  QuantityInfo info;
  bool rate = false;        ///< share of runs with value 1, with a Wilson interval: "success"
  bool wall_clock = false;  ///< measured time: differs from run to run of a campaign
};

/// One cell: what is known of one column in a group of runs.
struct Cell {
  std::size_t n = 0;                      ///< runs in the group
  std::size_t available = 0;              ///< of them with a value
  std::size_t failures = 0;               ///< of them with an outcome that is the method's failure
  std::map<std::string, std::size_t> na;  ///< runs without a value, by reason
  std::optional<double> estimate;         ///< mean, or rate
  std::optional<double> deviation;        ///< sample standard deviation
  std::optional<double> median;
  std::optional<double> interquartile_mean;
  std::optional<Interval> interval;  ///< of the estimate
};

/// The columns with these ids: metrics of the table, "success" even where it was not recorded as a
/// metric (then it follows from the outcome), or wall-clock figures such as "cycle_time_mean".
/// Throws Error (Usage) for any other, with the nearest name.
std::vector<Column> resolve_columns(const ResultTable& table, const std::vector<std::string>& ids);

/// Ids of all metrics that the runs have, and of the wall-clock figures.
std::vector<std::string> metric_ids(const ResultTable& table);
std::vector<std::string> wall_clock_ids(const ResultTable& table);

/// The value of a column for one run; NA with its reason where there is none, or where another
/// version of the formula made it.
Value column_value(const ResultTable& table, std::size_t run, const Column& column);

std::vector<Column> resolve_columns(const RunColumns& table, const std::vector<std::string>& ids);

/// Summarises `values` over `runs` (places in `table`). `label` names the cell: it selects the
/// bootstrap's random numbers, so that a cell does not depend on which others are computed.
Cell make_cell(const RunColumns& table, const std::vector<std::size_t>& runs,
               const ValueColumn& values, const AnalysisOptions& options, const std::string& label);

/// The same where the failures among the runs were counted before, as for many columns.
Cell make_cell(const RunColumns& table, const std::vector<std::size_t>& runs, std::size_t failures,
               const ValueColumn& values, const AnalysisOptions& options, const std::string& label);
std::size_t count_failures(const RunColumns& table, const std::vector<std::size_t>& runs);

/// The bounds of a metric or descriptor by its definition; none where it is not one of Slalom's.
ValueRange range_of(const std::string& id);

/// The methods of the runs, sorted.
std::vector<std::string> method_names(const ResultTable& table);

}  // namespace slalom
