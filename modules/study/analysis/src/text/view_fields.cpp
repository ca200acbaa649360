// SPDX-License-Identifier: BSD-3-Clause
#include "view_fields.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// The number of decimals that gives the largest number of a column four digits.
int digits_of(const DataTable& table, std::size_t column) {
  double largest = 0;
  for (std::size_t row = 0; row < table.rows; ++row) {
    const Field field = table.at(row, column);
    const double* number = std::get_if<double>(&field);
    if (number != nullptr && std::isfinite(*number)) largest = std::max(largest, std::abs(*number));
  }
  if (largest == 0) return 3;
  return std::clamp(3 - static_cast<int>(std::floor(std::log10(largest))), 0, 6);
}

std::string field_text(const Field& field, int digits) {
  if (const double* number = std::get_if<double>(&field)) {
    return std::abs(*number) < 1e9 ? format_fixed(*number, digits) : format_number(*number);
  }
  if (const auto* count = std::get_if<std::int64_t>(&field)) return std::to_string(*count);
  if (const auto* seed = std::get_if<std::uint64_t>(&field)) return std::to_string(*seed);
  if (const auto* text = std::get_if<std::string>(&field)) return printable_line(*text);
  return "-";
}

/// A displayed column: the table's column `first`, merged with the next two if they are its
/// interval.
struct ViewColumn {
  std::size_t first = 0;
  bool interval = false;
  int digits = 3;
};

std::vector<ViewColumn> view_columns(const DataTable& table) {
  std::vector<ViewColumn> views;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i] == "runs" && i + 1 == table.columns.size()) continue;
    ViewColumn view{i, false, digits_of(table, i)};
    view.interval = i + 2 < table.columns.size() &&
                    table.columns[i + 1] == table.columns[i] + ".low" &&
                    table.columns[i + 2] == table.columns[i] + ".high";
    if (view.interval) i += 2;
    views.push_back(view);
  }
  return views;
}

std::string view_text(const DataTable& table, std::size_t row, const ViewColumn& view) {
  const Field field = table.at(row, view.first);
  const double* number = std::get_if<double>(&field);
  // A metric of a foreign table may have such a name, but it has an interval.
  const bool is_p = !view.interval && is_p_column(table.columns[view.first]);
  if (is_p && number != nullptr) return p_number_text(*number);
  const std::string text = field_text(field, view.digits);
  if (!view.interval) return text;
  const Field low = table.at(row, view.first + 1), high = table.at(row, view.first + 2);
  if (std::holds_alternative<std::monostate>(low)) return text;
  return text + " [" + field_text(low, view.digits) + ", " + field_text(high, view.digits) + "]";
}

}  // namespace

ViewFields view_fields(const DataTable& table) {
  const std::vector<ViewColumn> views = view_columns(table);
  ViewFields fields;
  for (const ViewColumn& view : views) {
    const std::string& name = table.columns[view.first];
    fields.header.push_back(printable_line(ends_with(name, ".na") ? "NA" : name));
  }
  for (std::size_t row = 0; row < table.rows; ++row) {
    fields.rows.emplace_back();
    for (const ViewColumn& view : views) fields.rows.back().push_back(view_text(table, row, view));
  }
  return fields;
}

const std::vector<DataTable>& views_of(const Interpretation& interpretation) {
  return interpretation.views.empty() ? interpretation.tables : interpretation.views;
}

}  // namespace slalom
