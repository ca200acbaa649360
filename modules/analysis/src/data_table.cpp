#include <slalom/analysis/data_table.h>
#include <slalom/analysis/table_export.h>
#include <slalom/core/text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace slalom {
namespace {

Field field_of(const Value& value) {
  return value.is_na() ? Field{} : Field{value.number()};
}

Field field_of(const std::optional<double>& number) {
  return number ? Field{*number} : Field{};
}

template <typename Map>
Field value_in(const Map& values, const std::string& id) {
  const auto found = values.find(id);
  return found == values.end() ? Field{} : field_of(found->second.value);
}

std::vector<std::string> descriptor_ids(const ResultTable& table) {
  std::map<std::string, bool> ids;
  for (const auto& entry : table.scenarios) {
    for (const auto& descriptor : entry.second.descriptors) ids[descriptor.first] = true;
  }
  std::vector<std::string> names;
  for (const auto& entry : ids) names.push_back(entry.first);
  return names;
}

std::string reasons_of(const RunRecord& run) {
  std::vector<std::string> parts;
  for (const auto& [id, metric] : run.metrics) {
    if (metric.value.is_na()) parts.push_back(id + ": " + metric.value.reason());
  }
  return join(parts, "; ");
}

using RunField = std::function<Field(const RunRecord&)>;

Field integer(std::uint64_t number) {
  return static_cast<std::int64_t>(number);
}

/// What every run has, whatever was measured.
std::vector<std::pair<std::string, RunField>> run_basics() {
  return {
      {"run", [](const RunRecord& run) { return Field{run_id(run)}; }},
      {"scenario", [](const RunRecord& run) { return Field{run.scenario_name}; }},
      {"scenario_hash", [](const RunRecord& run) { return Field{run.scenario_hash}; }},
      {"method", [](const RunRecord& run) { return Field{run.method}; }},
      {"repetition", [](const RunRecord& run) { return Field{std::int64_t{run.repetition}}; }},
      {"seed", [](const RunRecord& run) { return integer(run.seed); }},
      {"outcome", [](const RunRecord& run) { return Field{run.outcome}; }},
      {"outcome_detail", [](const RunRecord& run) { return Field{run.outcome_detail}; }},
      {"trajectory_hash", [](const RunRecord& run) { return Field{run.trajectory_hash}; }},
  };
}

Field descriptor_field(const ResultTable& table, const RunRecord& run, const std::string& id) {
  const auto scenario = table.scenarios.find(run.scenario_hash);
  return scenario == table.scenarios.end() ? Field{} : value_in(scenario->second.descriptors, id);
}

struct CellPart {
  const char* suffix;
  Field (*field)(const Cell& cell);
};

/// What is told of each cell: the column's id, then these suffixes.
constexpr CellPart kCellParts[] = {
    {"", [](const Cell& cell) { return field_of(cell.estimate); }},
    {".low", [](const Cell& c) { return c.interval ? Field{c.interval->low} : Field{}; }},
    {".high", [](const Cell& c) { return c.interval ? Field{c.interval->high} : Field{}; }},
    {".deviation", [](const Cell& cell) { return field_of(cell.deviation); }},
    {".median", [](const Cell& cell) { return field_of(cell.median); }},
    {".n", [](const Cell& cell) { return integer(cell.n); }},
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
  if (const auto* text = std::get_if<std::string>(&field)) return csv_field(*text);
  return "";
}

nlohmann::ordered_json json_of(const Field& field) {
  if (const auto* number = std::get_if<double>(&field)) return *number;
  if (const auto* count = std::get_if<std::int64_t>(&field)) return *count;
  if (const auto* text = std::get_if<std::string>(&field)) return *text;
  return nullptr;
}

}  // namespace

DataTable runs_table(const ResultTable& table) {
  const auto basics = run_basics();
  const std::vector<std::string> metrics = metric_ids(table), descriptors = descriptor_ids(table);
  DataTable data{"runs", "Runs", {}, table.runs.size(), {}};
  for (const auto& basic : basics) data.columns.push_back(basic.first);
  data.columns.insert(data.columns.end(), metrics.begin(), metrics.end());
  data.columns.emplace_back("not_available");
  for (const std::string& id : descriptors) data.columns.push_back("scenario." + id);
  data.at = [&table, basics, metrics, descriptors](std::size_t row, std::size_t column) {
    const RunRecord& run = table.runs[row];
    if (column < basics.size()) return basics[column].second(run);
    column -= basics.size();
    if (column < metrics.size()) return value_in(run.metrics, metrics[column]);
    column -= metrics.size();
    return column == 0 ? Field{reasons_of(run)}
                       : descriptor_field(table, run, descriptors[column - 1]);
  };
  return data;
}

DataTable scenarios_table(const ResultTable& table) {
  const std::vector<std::string> ids = descriptor_ids(table);
  auto scenarios = std::make_shared<std::vector<const ScenarioRecord*>>();
  for (const auto& entry : table.scenarios) scenarios->push_back(&entry.second);
  DataTable data{"scenarios", "Scenarios", {"scenario_hash", "scenario"}, scenarios->size(), {}};
  data.columns.insert(data.columns.end(), ids.begin(), ids.end());
  data.at = [scenarios, ids](std::size_t row, std::size_t column) {
    const ScenarioRecord& scenario = *(*scenarios)[row];
    if (column < 2) return Field{column == 0 ? scenario.hash : scenario.name};
    return value_in(scenario.descriptors, ids[column - 2]);
  };
  return data;
}

DataTable timings_table(const ResultTable& table) {
  const std::vector<std::string> ids = wall_clock_ids(table);
  const std::size_t rows = std::min(table.timings.size(), table.runs.size());
  DataTable data{"timings", "Wall-clock figures", {"run", "wall_seconds"}, rows, {}};
  for (const std::string& id : ids)
    data.columns.push_back(timing_unit(id) == "-" ? id : id + "_" + timing_unit(id));
  data.at = [&table, ids](std::size_t row, std::size_t column) {
    const RunTiming& timing = table.timings[row];
    if (column == 0) return Field{run_id(table.runs[row])};
    if (column == 1) return Field{timing.wall_seconds};
    const auto found = timing.values.find(ids[column - 2]);
    return found == timing.values.end() ? Field{} : Field{found->second};
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
  DataTable data{table.method + "_by_" + table.descriptor.id,
                 table.title,
                 {"method", "descriptor", "bin", "bin_low", "bin_high", "runs"},
                 table.rows.size(),
                 {}};
  const std::size_t basics = data.columns.size();
  add_cell_columns(table.columns, data);
  data.at = [&table, basics](std::size_t row, std::size_t column) -> Field {
    const CrossRow& line = table.rows[row];
    if (column >= basics) return cell_field(line.cells, column - basics);
    const Field fields[] = {
        table.method,           table.descriptor.id,     line.bin.label(),
        field_of(line.bin.low), field_of(line.bin.high), integer(line.runs.size())};
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
