// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cell_json.h>
#include <slalom/analysis/table_export.h>
#include <slalom/core/text.h>

#include <nlohmann/json.hpp>

#include <cstring>

namespace slalom {
namespace {

using Json = nlohmann::ordered_json;

std::string number_field(const std::optional<double>& number) {
  return number ? format_number(*number) : "";
}

std::string reasons_field(const Cell& cell) {
  std::vector<std::string> parts;
  for (const auto& [reason, n] : cell.na) parts.push_back(reason + "=" + std::to_string(n));
  return join(parts, "; ");
}

std::string cell_line(const CrossTable& table, const CrossRow& row, std::size_t column) {
  const Cell& cell = row.cells[column];
  const QuantityInfo& info = table.columns[column].info;
  const std::vector<std::string> fields = {table.method,
                                           table.descriptor.id,
                                           number_field(row.bin.low),
                                           number_field(row.bin.high),
                                           info.id,
                                           std::to_string(info.version),
                                           std::to_string(cell.n),
                                           std::to_string(cell.available),
                                           std::to_string(cell.n - cell.available),
                                           number_field(cell.estimate),
                                           number_field(cell.deviation),
                                           cell.interval ? format_number(cell.interval->low) : "",
                                           cell.interval ? format_number(cell.interval->high) : "",
                                           format_number(table.confidence),
                                           reasons_field(cell)};
  return csv_line(fields);
}

Json field_json(const Cell& cell, const Column& column) {
  Json json = {{"metric", column.info.id},
               {"version", column.info.version},
               {"unit", column.info.unit},
               {"direction", to_string(column.info.direction)},
               {"wall_clock", column.wall_clock}};
  json.update(cell_json(cell));
  return json;
}

Json table_json(const CrossTable& table) {
  Json rows = Json::array();
  for (const CrossRow& row : table.rows) {
    Json cells = Json::array();
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      cells.push_back(field_json(row.cells[column], table.columns[column]));
    }
    rows.push_back({{"bin", row.bin.label()},
                    {"low", number_or_null(row.bin.low)},
                    {"high", number_or_null(row.bin.high)},
                    {"high_included", row.bin.closed},
                    {"runs", row.run_ids},
                    {"cells", cells}});
  }
  return {{"method", table.method},         {"row_descriptor", table.descriptor.id},
          {"confidence", table.confidence}, {"rows", rows},
          {"outside", table.outside},       {"undescribed", table.undescribed},
          {"trends", trends_json(table)}};
}

}  // namespace

bool is_formula(const std::string& text) {
  double number = 0;
  return text.size() > 1 && std::strchr("=+-@\t\r", text[0]) != nullptr &&
         !parse_number(text, number);
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::vector<std::string> quoted;
  for (const std::string& field : fields) quoted.push_back(csv_field(field));
  return join(quoted, ",") + "\n";
}

std::string csv_field(const std::string& text) {
  // Programs split at any of these, also within quotes that do not begin a field.
  constexpr const char* kSeparators = ",;\t\"\r\n";
  std::string field;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(kSeparators, begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    field += (is_formula(part) ? "'" : "") + part + text.substr(end, 1);
    begin = end + 1;
  }
  if (field.find_first_of(kSeparators) == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string render_csv(const std::vector<CrossTable>& tables) {
  std::string text =
      "method,row_descriptor,bin_low,bin_high,metric,version,runs,n,na,mean,deviation,low,"
      "high,confidence,na_reasons\n";
  for (const CrossTable& table : tables) {
    for (const CrossRow& row : table.rows) {
      for (std::size_t column = 0; column < table.columns.size(); ++column) {
        text += cell_line(table, row, column);
      }
    }
  }
  return text;
}

std::string render_json(const std::vector<CrossTable>& tables) {
  Json json = Json::array();
  for (const CrossTable& table : tables) json.push_back(table_json(table));
  // Names from files may not be UTF-8: invalid bytes are replaced.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace slalom
