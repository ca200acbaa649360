// SPDX-License-Identifier: BSD-3-Clause
#include "row_table.h"

#include <slalom/analysis/cross_table.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {

void RowTable::begin_row() {
  rows_.emplace_back();
}

void RowTable::add(const std::string& column, Field field) {
  const std::size_t index = rows_.back().size();
  if (index == columns_.size()) columns_.push_back(column);
  rows_.back().push_back(std::move(field));
}

void RowTable::add(const std::string& column, const std::optional<double>& number) {
  add(column, number ? Field{*number} : Field{});
}

void RowTable::add(const std::string& column, std::size_t count) {
  add(column, Field{static_cast<std::int64_t>(count)});
}

void RowTable::add(const std::string& column, const std::optional<double>& estimate,
                   const std::optional<Interval>& interval) {
  add(column, estimate);
  add(column + ".low", interval ? Field{interval->low} : Field{});
  add(column + ".high", interval ? Field{interval->high} : Field{});
}

void RowTable::add_cell(const std::string& column, const Cell& cell) {
  add(column, cell.estimate, cell.interval);
  add(column + ".sd", cell.deviation);
  add(column + ".interval_na", Field{cell.interval_na});
  add(column + ".median", cell.median, cell.median_interval);
  add(column + ".iqm", cell.interquartile_mean);
  add(column + ".n", cell.available);
  add(column + ".na", cell.n - cell.available);
  add(column + ".failures", cell.failures);
  std::vector<std::string> reasons;
  for (const auto& [reason, n] : cell.na) reasons.push_back(std::to_string(n) + " " + reason);
  add(column + ".na_reasons", Field{join(reasons, "; ")});
  add(column + ".empty", Field{empty_reason(cell)});
}

void RowTable::add_statement(const QuantityInfo& info, const Cell& cell) {
  add(info.id, cell.estimate, cell.interval);
  if (states_median(info)) add(info.id + ".median", cell.median, cell.median_interval);
}

void RowTable::add_shown_cell(const QuantityInfo& info, const Cell& cell) {
  add("n", cell.available);
  add_statement(info, cell);
  add(info.id + ".na", cell.n - cell.available);
}

void RowTable::add_change(const std::optional<PairedComparison>& change) {
  add("change", change ? change->difference : std::nullopt,
      change ? change->interval : std::nullopt);
  add("p_holm", change ? std::optional(change->adjusted_p) : std::nullopt);
  if (change) {
    add("family", change->family);
  } else {
    add("family", std::optional<double>());
  }
  add("verdict", Field{change ? to_string(change->verdict) : std::string()});
}

void RowTable::add_runs(const ResultTable& table, const std::vector<std::size_t>& runs) {
  std::string ids;
  for (const std::size_t run : runs) ids += (ids.empty() ? "" : " ") + run_id(table, run);
  add("runs", Field{ids});
}

DataTable RowTable::table() const {
  const auto rows = std::make_shared<std::vector<std::vector<Field>>>(rows_);
  return {name_, title_, columns_, rows_.size(), [rows](std::size_t row, std::size_t column) {
            return column < (*rows)[row].size() ? (*rows)[row][column] : Field{};
          }};
}

std::string empty_reason(const Cell& cell) {
  if (cell.estimate) return "";
  if (cell.n == 0) return "no runs";
  std::vector<std::string> reasons;
  for (const auto& [reason, n] : cell.na) reasons.push_back(std::to_string(n) + " " + reason);
  return "no values: " + join(reasons, "; ");
}

std::vector<std::string> selected_methods(const ResultTable& table, const std::string& method) {
  if (method.empty()) return table.methods;
  return {table.methods[index_of_method(table, method)]};
}

}  // namespace slalom
