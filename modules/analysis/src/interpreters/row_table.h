#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/analysis/data_table.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A data table that keeps its rows, filled from left to right.
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
  /// The cell whole: estimate, interval, deviation, median, interquartile mean, counts, reasons.
  void add_cell(const std::string& column, const Cell& cell);
  /// Ids of runs, separated by blanks; the column is called "runs".
  void add_runs(const RunColumns& table, const std::vector<std::size_t>& runs);

  DataTable table() const;  ///< keeps the rows alive by itself

 private:
  std::string name_, title_;
  std::vector<std::string> columns_;
  std::vector<std::vector<Field>> rows_;
};

/// "no runs", "no values: 3 outcome: stuck"; empty where there is an estimate.
std::string why_empty(const Cell& cell);

/// The methods that the question is about. Throws Error (Usage) for an unknown one.
std::vector<std::string> asked_methods(const RunColumns& table, const std::string& method);

}  // namespace slalom
