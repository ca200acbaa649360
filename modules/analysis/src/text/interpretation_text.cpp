#include "text_grid.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/table_export.h>
#include <slalom/analysis/table_text.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <nlohmann/json.hpp>

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
  const std::string text = field_text(table.at(row, view.first), view.digits);
  if (!view.interval) return text;
  const Field low = table.at(row, view.first + 1), high = table.at(row, view.first + 2);
  if (std::holds_alternative<std::monostate>(low)) return text;
  return text + " [" + field_text(low, view.digits) + ", " + field_text(high, view.digits) + "]";
}

std::string table_text(const DataTable& table) {
  const std::string head = table.title.empty() ? "" : printable_line(table.title) + "\n\n";
  if (table.rows == 0) return head + "(empty)\n";
  const std::vector<ViewColumn> views = view_columns(table);
  std::vector<std::string> header;
  for (const ViewColumn& view : views) {
    const std::string& name = table.columns[view.first];
    header.push_back(printable_line(ends_with(name, ".na") ? "NA" : name));
  }
  TextGrid grid(header);
  for (std::size_t row = 0; row < table.rows; ++row) {
    std::vector<TextGrid::Lines> cells;
    for (const ViewColumn& view : views) cells.push_back({view_text(table, row, view)});
    grid.add_row(std::move(cells));
  }
  return head + grid.text();
}

std::string cross_tables_text(const Interpretation& interpretation) {
  std::string text = interpretation.summary ? render_summary_text(*interpretation.summary) : "";
  for (const CrossTable& table : *interpretation.cross_tables) {
    text += (text.empty() ? "" : "\n\n") + render_cross_table_text(table);
  }
  return text;
}

}  // namespace

std::string render_text(const Interpretation& interpretation) {
  if (interpretation.cross_tables) return cross_tables_text(interpretation);
  std::string text;
  const auto& tables = interpretation.views.empty() ? interpretation.tables : interpretation.views;
  for (const DataTable& table : tables) text += (text.empty() ? "" : "\n") + table_text(table);
  if (!interpretation.remarks.empty()) text += "\n";
  for (const std::string& remark : interpretation.remarks)
    text += "→ " + printable_line(remark) + "\n";
  return text;
}

std::string render_json(const Interpretation& interpretation) {
  if (interpretation.cross_tables) return render_json(*interpretation.cross_tables);
  using Json = nlohmann::ordered_json;
  Json json = {{"tables", Json::array()},
               {"remarks", interpretation.remarks},
               {"passed", interpretation.passed}};
  for (const DataTable& table : interpretation.tables) {
    json["tables"].push_back(Json::parse(render_json(table)));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string render_csv(const Interpretation& interpretation) {
  if (interpretation.cross_tables) return render_csv(*interpretation.cross_tables);
  std::string text;
  for (const DataTable& table : interpretation.tables) {
    text += (text.empty() ? "" : "\n") + render_csv(table);
  }
  return text;
}

}  // namespace slalom
