// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/data_table.h>
#include <slalom/analysis/table_export.h>
#include <slalom/core/text.h>

#include <nlohmann/json.hpp>

#include <iterator>
#include <memory>

namespace slalom {
namespace {

Field field_of(const std::optional<double>& number) {
  return number ? Field{*number} : Field{};
}

Field field_of(const ValueColumn& values, std::size_t row) {
  return values.is_na(row) ? Field{} : Field{values.number(row)};
}

Field integer(std::uint64_t number) {
  return static_cast<std::int64_t>(number);
}

template <typename T>
Field detail_of(const ResultTable& table, std::size_t run, T RunDetails::*detail) {
  return table.details.empty() ? Field{} : Field{table.details[run].*detail};
}

struct RunField {
  const char* name;
  Field (*field)(const ResultTable& table, std::size_t run);
};

/// The columns that every run has.
constexpr RunField kRunFields[] = {
    {"run", [](const ResultTable& t, std::size_t run) { return Field{run_id(t, run)}; }},
    {"scenario", [](const ResultTable& t,
                    std::size_t run) { return Field{t.scenario_names[t.scenario[run]]}; }},
    {"scenario_hash", [](const ResultTable& t,
                         std::size_t run) { return Field{t.scenario_hashes[t.scenario[run]]}; }},
    {"method",
     [](const ResultTable& t, std::size_t run) { return Field{t.methods[t.method[run]]}; }},
    {"repetition",
     [](const ResultTable& t, std::size_t run) { return integer(t.repetition[run]); }},
    {"seed",
     [](const ResultTable& t, std::size_t run) { return detail_of(t, run, &RunDetails::seed); }},
    {"outcome",
     [](const ResultTable& t, std::size_t run) { return Field{t.outcomes[t.outcome[run]]}; }},
    {"outcome_detail",
     [](const ResultTable& t, std::size_t run) {
       return detail_of(t, run, &RunDetails::outcome_detail);
     }},
    {"trajectory_hash",
     [](const ResultTable& t, std::size_t run) {
       return detail_of(t, run, &RunDetails::trajectory_hash);
     }},
};

/// The metrics that are wall-clock figures, or those that are not.
std::vector<const ValueColumn*> metrics_of(const ResultTable& table, bool wall_clock) {
  std::vector<const ValueColumn*> metrics;
  for (const ValueColumn& column : table.metrics)
    if (column.wall_clock == wall_clock) metrics.push_back(&column);
  return metrics;
}

std::string reasons_of(const std::vector<const ValueColumn*>& metrics, std::size_t run) {
  std::vector<std::string> parts;
  for (const ValueColumn* metric : metrics)
    if (metric->is_na(run)) parts.push_back(metric->info().id + ": " + metric->reason(run));
  return join(parts, "; ");
}

Field low_of(const std::optional<Interval>& interval) {
  return interval ? Field{interval->low} : Field{};
}

Field high_of(const std::optional<Interval>& interval) {
  return interval ? Field{interval->high} : Field{};
}

struct CellPart {
  const char* suffix;
  Field (*field)(const Cell& cell);
};

/// The columns of each cell: the metric's id followed by these suffixes.
constexpr CellPart kCellParts[] = {
    {"", [](const Cell& cell) { return field_of(cell.estimate); }},
    {".low", [](const Cell& cell) { return low_of(cell.interval); }},
    {".high", [](const Cell& cell) { return high_of(cell.interval); }},
    {".deviation", [](const Cell& cell) { return field_of(cell.deviation); }},
    {".median", [](const Cell& cell) { return field_of(cell.median); }},
    {".median.low", [](const Cell& cell) { return low_of(cell.median_interval); }},
    {".median.high", [](const Cell& cell) { return high_of(cell.median_interval); }},
    {".n", [](const Cell& cell) { return integer(cell.available); }},
    {".na", [](const Cell& cell) { return integer(cell.n - cell.available); }},
};

void add_cell_columns(const std::vector<Column>& columns, DataTable& data) {
  for (const Column& column : columns) {
    for (const CellPart& part : kCellParts) data.columns.push_back(column.info.id + part.suffix);
  }
}

/// Field `index` of a row of cells.
Field cell_field(const std::vector<Cell>& cells, std::size_t index) {
  constexpr std::size_t kParts = std::size(kCellParts);
  return kCellParts[index % kParts].field(cells[index / kParts]);
}

std::string csv_text(const Field& field) {
  if (const auto* number = std::get_if<double>(&field)) return format_number(*number);
  if (const auto* count = std::get_if<std::int64_t>(&field)) return std::to_string(*count);
  if (const auto* seed = std::get_if<std::uint64_t>(&field)) return std::to_string(*seed);
  if (const auto* text = std::get_if<std::string>(&field)) return csv_field(*text);
  return "";
}

nlohmann::ordered_json json_of(const Field& field) {
  if (const auto* number = std::get_if<double>(&field)) return *number;
  if (const auto* count = std::get_if<std::int64_t>(&field)) return *count;
  if (const auto* seed = std::get_if<std::uint64_t>(&field)) return *seed;
  if (const auto* text = std::get_if<std::string>(&field)) return *text;
  return nullptr;
}

}  // namespace

DataTable runs_table(const ResultTable& table) {
  const auto metrics = metrics_of(table, false);
  DataTable data{"runs", "Runs", {}, table.size(), {}};
  for (const RunField& field : kRunFields) data.columns.emplace_back(field.name);
  for (const ValueColumn* metric : metrics) data.columns.push_back(metric->info().id);
  data.columns.emplace_back("not_available");
  for (const ValueColumn& descriptor : table.descriptors)
    data.columns.push_back("scenario." + descriptor.info().id);
  data.at = [&table, metrics](std::size_t row, std::size_t column) {
    if (column < std::size(kRunFields)) return kRunFields[column].field(table, row);
    column -= std::size(kRunFields);
    if (column < metrics.size()) return field_of(*metrics[column], row);
    column -= metrics.size();
    return column == 0 ? Field{reasons_of(metrics, row)}
                       : field_of(table.descriptors[column - 1], table.scenario[row]);
  };
  return data;
}

DataTable scenarios_table(const ResultTable& table) {
  const std::size_t rows = table.scenario_hashes.size();
  DataTable data{"scenarios", "Scenarios", {"scenario_hash", "scenario"}, rows, {}};
  for (const ValueColumn& descriptor : table.descriptors)
    data.columns.push_back(descriptor.info().id);
  data.at = [&table](std::size_t row, std::size_t column) {
    if (column == 0) return Field{table.scenario_hashes[row]};
    if (column == 1) return Field{table.scenario_names[row]};
    return field_of(table.descriptors[column - 2], row);
  };
  return data;
}

DataTable timings_table(const ResultTable& table) {
  const auto figures = metrics_of(table, true);
  const std::size_t rows = table.details.size();
  DataTable data{"timings", "Wall-clock measurements", {"run", "wall_seconds"}, rows, {}};
  for (const ValueColumn* figure : figures) {
    const QuantityInfo& info = figure->info();
    data.columns.push_back(info.unit == "-" ? info.id : info.id + "_" + info.unit);
  }
  data.at = [&table, figures](std::size_t row, std::size_t column) {
    if (column == 0) return Field{run_id(table, row)};
    if (column == 1) return Field{table.details[row].wall_seconds};
    return field_of(*figures[column - 2], row);
  };
  return data;
}

DataTable manifest_table(const ResultTable& table) {
  auto lines = std::make_shared<std::vector<std::pair<std::string, std::string>>>(
      table.manifest.begin(), table.manifest.end());
  return {"manifest",
          "Manifest",
          {"key", "text"},
          lines->size(),
          [lines](std::size_t row, std::size_t column) {
            return Field{column == 0 ? (*lines)[row].first : (*lines)[row].second};
          }};
}

DataTable summary_data(const SummaryTable& table) {
  DataTable data{"summary", "All scenarios", {"method", "runs"}, table.methods.size(), {}};
  for (const std::string& outcome : table.outcomes) data.columns.push_back("outcome." + outcome);
  const std::size_t outcomes = table.outcomes.size();
  add_cell_columns(table.columns, data);
  data.at = [&table, outcomes](std::size_t row, std::size_t column) {
    const MethodSummary& method = table.methods[row];
    if (column == 0) return Field{method.method};
    if (column == 1) return integer(method.n);
    if (column >= 2 + outcomes) return cell_field(method.cells, column - 2 - outcomes);
    const auto found = method.outcomes.find(table.outcomes[column - 2]);
    return integer(found == method.outcomes.end() ? 0 : found->second);
  };
  return data;
}

DataTable cross_data(const CrossTable& table) {
  DataTable data{unmarked_name(table.method) + "_by_" + table.descriptor.id,
                 table.title,
                 {"method", "descriptor", "bin", "bin_low", "bin_high", "runs"},
                 table.rows.size(),
                 {}};
  const std::size_t basics = data.columns.size();
  add_cell_columns(table.columns, data);
  data.at = [&table, basics](std::size_t row, std::size_t column) -> Field {
    const CrossRow& line = table.rows[row];
    if (column >= basics) return cell_field(line.cells, column - basics);
    const Field fields[] = {table.method,           table.descriptor.id,     line.bin.label(),
                            field_of(line.bin.low), field_of(line.bin.high), integer(line.n)};
    return fields[column];
  };
  return data;
}

std::string render_csv(const DataTable& table) {
  std::vector<std::string> names = table.columns;
  for (std::string& name : names) name = csv_field(name);
  std::string text = join(names, ",") + "\n";
  for (std::size_t row = 0; row < table.rows; ++row) {
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      if (column > 0) text += ',';
      text += csv_text(table.at(row, column));
    }
    text += '\n';
  }
  return text;
}

std::string render_json(const DataTable& table) {
  nlohmann::ordered_json json = {
      {"name", table.name}, {"columns", table.columns}, {"rows", nlohmann::ordered_json::array()}};
  for (std::size_t row = 0; row < table.rows; ++row) {
    auto line = nlohmann::ordered_json::array();
    for (std::size_t column = 0; column < table.columns.size(); ++column)
      line.push_back(json_of(table.at(row, column)));
    json["rows"].push_back(std::move(line));
  }
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace slalom
