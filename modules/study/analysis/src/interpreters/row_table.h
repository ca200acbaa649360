// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/analysis/data_table.h>
#include <slalom/analysis/paired_comparison.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Builds a data table row by row, from left to right.
class RowTable {
 public:
  RowTable(std::string name, std::string title)
      : name_(std::move(name)), title_(std::move(title)) {}

  void begin_row();
  void add(const std::string& column, Field field);
  void add(const std::string& column, const std::optional<double>& number);
  void add(const std::string& column, std::size_t count);
  /// COLUMN, COLUMN.low, COLUMN.high.
  void add(const std::string& column, const std::optional<double>& estimate,
           const std::optional<Interval>& interval);
  /// The complete cell: estimate, deviation and median with intervals, interquartile mean,
  /// counts, reasons.
  void add_cell(const std::string& column, const Cell& cell);
  /// The mean with its interval, and the median with its own if it states_median().
  void add_statement(const QuantityInfo& info, const Cell& cell);
  /// n, add_statement(), number of NA: what a display shows of a cell.
  void add_shown_cell(const QuantityInfo& info, const Cell& cell);
  /// Difference with interval, corrected p, size of its family, verdict; without a change empty
  /// fields.
  void add_change(const std::optional<PairedComparison>& change);
  /// Ids of runs, separated by blanks; the column is called "runs".
  void add_runs(const ResultTable& table, const std::vector<std::size_t>& runs);

  DataTable table() const;  ///< owns its rows

 private:
  std::string name_, title_;
  std::vector<std::string> columns_;
  std::vector<std::vector<Field>> rows_;
};

/// "no runs", "no values: 3 outcome: stuck"; empty if there is an estimate.
std::string empty_reason(const Cell& cell);

/// `method`, or all methods if it is empty. Throws Error (Usage) for an unknown method.
std::vector<std::string> selected_methods(const ResultTable& table, const std::string& method);

/// Leaves those of `entries` (each with a `method`) that the query is about.
template <typename Entry>
std::vector<Entry> of_method(std::vector<Entry> entries, const std::string& method) {
  if (method.empty()) return entries;
  entries.erase(std::remove_if(entries.begin(), entries.end(),
                               [&](const Entry& entry) { return entry.method != method; }),
                entries.end());
  return entries;
}

}  // namespace slalom
