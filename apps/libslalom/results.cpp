// SPDX-License-Identifier: BSD-3-Clause
#include "calls.h"
#include "results.h"
#include "scenarios.h"

#include <slalom/analysis/analysis_request.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/evaluate.h>
#include <slalom/io/merge_results.h>
#include <slalom/io/own_columns.h>
#include <slalom/io/read_results.h>
#include <slalom/metrics/metric.h>
#include <slalom/report/report.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

using Json = nlohmann::json;

/// Throws Error (Usage) for null.
const slalom_results& valid(const slalom_results* results) {
  if (results == nullptr) throw usage_error("results", "are a null pointer", "results");
  return *results;
}

template <typename Make>
char* text_about(const slalom_results* results, Make make) {
  return guarded<char*>(nullptr, [&] { return to_owned(make(valid(results))); });
}

Json names_by_run(const std::vector<std::string>& names,
                  const std::vector<std::uint32_t>& indexes) {
  Json list = Json::array();
  for (const std::uint32_t index : indexes) list.push_back(names[index]);
  return list;
}

/// A column with the row of a run in it.
struct RunColumn {
  const ValueColumn* values;
  bool by_scenario;

  std::size_t row(const ResultTable& table, std::size_t run) const {
    return by_scenario ? table.scenario[run] : run;
  }
};

/// Metrics, then descriptors: repeatable ones, or wall-clock figures.
std::vector<RunColumn> columns_of(const ResultTable& table, bool wall_clock) {
  std::vector<RunColumn> columns;
  for (const ValueColumn& column : table.metrics)
    if (column.wall_clock == wall_clock) columns.push_back({&column, false});
  for (const ValueColumn& column : table.descriptors)
    if (!wall_clock) columns.push_back({&column, true});
  return columns;
}

Json ids_of(const std::vector<RunColumn>& columns) {
  Json ids = Json::array();
  for (const RunColumn& column : columns) ids.push_back(column.values->info().id);
  return ids;
}

Json reasons_of(const ResultTable& table) {
  Json reasons = Json::object();
  for (const RunColumn& column : columns_of(table, false)) {
    Json& by_run = reasons[column.values->info().id] = Json::object();
    for (std::size_t run = 0; run < table.size(); ++run)
      if (const std::size_t row = column.row(table, run); column.values->is_na(row))
        by_run[std::to_string(run)] = column.values->reason(row);
  }
  return reasons;
}

std::string describe_results(const slalom_results& results) {
  const ResultTable& table = results.table;
  Json details = Json::array();
  for (const RunDetails& run : table.details) details.push_back(run.outcome_detail);
  return Json({{"columns",
                {{"scenario", names_by_run(table.scenario_names, table.scenario)},
                 {"scenario_hash", names_by_run(table.scenario_hashes, table.scenario)},
                 {"method", names_by_run(table.methods, table.method)},
                 {"repetition", table.repetition},
                 {"outcome", names_by_run(table.outcomes, table.outcome)},
                 {"detail", details}}},
               {"numbers", ids_of(columns_of(table, false))},
               {"timing", ids_of(columns_of(table, true))},
               {"reasons", reasons_of(table)},
               {"manifest", table.manifest}})
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

double* numbers_of(const ResultTable& table, const std::string& id) {
  for (const bool wall_clock : {false, true})
    for (const RunColumn& column : columns_of(table, wall_clock)) {
      if (column.values->info().id != id) continue;
      auto* numbers = owned_array<double>(table.size());
      for (std::size_t run = 0; run < table.size(); ++run)
        numbers[run] = column.values->number(column.row(table, run));
      return numbers;
    }
  throw usage_error("'" + id + "'", "is not a column", "one of \"numbers\" or \"timing\"");
}

/// Throws Error (Usage) for results of evaluate() without an output.
const std::string& path_of(const slalom_results& results) {
  if (results.path.empty())
    throw usage_error("results", "are in no file", "an output of slalom_evaluate()");
  return results.path;
}

ResultFiles& files_of(const slalom_results& results) {
  if (results.files == nullptr) results.files = std::make_unique<ResultFiles>(path_of(results));
  return *results.files;
}

std::vector<Scenario> scenarios_of(const slalom_results& results) {
  std::vector<Scenario> scenarios;
  for (const std::string& hash : results.table.scenario_hashes)
    scenarios.push_back(files_of(results).with_scenario(hash).at(0)->read_scenario(hash));
  return scenarios;
}

Trajectory read_trajectory(const slalom_results& results, std::size_t run) {
  const ResultTable& table = results.table;
  if (run >= table.size())
    throw usage_error("run " + std::to_string(run), "is not in the results",
                      "less than " + std::to_string(table.size()));
  const std::string& hash = table.scenario_hashes[table.scenario[run]];
  for (const ResultFile* file : files_of(results).with_scenario(hash))
    if (const auto record = file->read_run(hash, table.methods[table.method[run]],
                                           static_cast<int>(table.repetition[run])))
      return file->read_trajectory(*record);
  throw file_error(results.path, "has no run " + std::to_string(run), "the file of the results");
}

ResultTable read_table(const std::string& path) {
  ResultTable table = read_detailed_results(path);
  if (!table.damaged.empty())
    throw file_error(path, "damaged: " + join(table.damaged, ", "),
                     "slalom-analyze, which leaves out what is damaged");
  return table;
}

/// Copies a result file, or merges those of a folder.
void save(const std::string& path, const std::string& output) {
  if (!ends_with(output, ".results"))
    throw usage_error(output, "is not the name of a result file", "FILE.results");
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) {
    require_regular_file(path, "a result file (.results)");
    std::ifstream file(path, std::ios::binary);
    return write_file_atomically(output, [&](std::ostream& out) { out << file.rdbuf(); });
  }
  const std::vector<std::string> files = campaign_files(path);
  MergedResults merged(output, files.at(0));
  for (const std::string& file : files) merged.add(file);
  merged.publish();
}

template <typename Enum>
Enum named(const Json& column, const char* key) {
  const std::string name = column.at(key);
  if (const auto found = from_name<Enum>(name)) return *found;
  throw usage_error(key, "unknown '" + name + "'", expected_name(name, names_of<Enum>()));
}

QuantityInfo info_of(const Json& column) {
  const std::string id = column.at("id"), range = column.at("range");
  const auto parsed = parse_range(range);
  if (!parsed)
    throw usage_error("range", "'" + range + "' is not valid", "LOW..HIGH, such as 0..1");
  const Json& version = column.at("version");
  constexpr int kMaxVersion = 1'000'000;
  if (!version.is_number_integer() || version < 1 || version > kMaxVersion)
    throw usage_error("version", "'" + version.dump() + "' is not valid",
                      "an integer in [1, " + std::to_string(kMaxVersion) + "]");
  if (contains(metric_ids(), id) || contains(descriptor_ids(), id))
    throw usage_error(id, "is a quantity of Slalom", "another name");
  return {id,
          version,
          id,
          column.at("unit"),
          named<Direction>(column, "better"),
          named<QuantityKind>(column, "kind"),
          *parsed};
}

OwnColumn own_column(const Json& column) {
  const std::string of = column.at("of");
  if (of != "scenarios" && of != "runs")
    throw usage_error("of", "unknown '" + of + "'", "runs or scenarios");
  OwnColumn own{ValueColumn(info_of(column)), of == "scenarios", column.at("source")};
  for (const Json& value : column.at("values"))
    if (value.is_string())
      own.values.add_na(value);
    else
      own.values.add_number(value);
  return own;
}

/// Shards are merged first.
ResultTable add_column(const slalom_results& results, const Json& column, const std::string& path) {
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(path_of(results), ignored);
  if (is_folder) save(results.path, path);
  write_with_column(ResultFile::open(is_folder ? path : results.path), results.table,
                    own_column(column), path);
  return read_table(path);
}

std::string summarize(const slalom_results& results) {
  const std::vector<Interpreter>& all = all_interpreters();
  const Interpreter& summary = *std::find_if(
      all.begin(), all.end(), [](const Interpreter& one) { return one.id == "summary"; });
  std::vector<ResultTable> tables = {results.table};
  Interpretation found = interpret(summary, tables, make_query({}, summary, results.table));
  MethodFailures failures;
  add_method_failures(results.table, results.path, failures);
  const auto lines = failures.lines();
  found.remarks.insert(found.remarks.begin(), lines.begin(), lines.end());
  return render_text(found);
}

}  // namespace
}  // namespace slalom

using namespace slalom;

slalom_results* slalom_results_read(const char* path) {
  return guarded<slalom_results*>(nullptr, [&] {
    const std::string file = text_of(path, "path");
    return new slalom_results{read_table(file), file, nullptr};
  });
}

void slalom_results_free(slalom_results* results) {
  const std::unique_ptr<slalom_results> owner(results);
}

size_t slalom_results_size(const slalom_results* results) {
  return results == nullptr ? 0 : results->table.size();
}

char* slalom_results_json(const slalom_results* results) {
  return text_about(results, describe_results);
}

double* slalom_results_numbers(const slalom_results* results, const char* id) {
  return guarded<double*>(nullptr,
                          [&] { return numbers_of(valid(results).table, text_of(id, "id")); });
}

double* slalom_results_trajectory(const slalom_results* results, size_t run, size_t* samples) {
  return guarded<double*>(nullptr, [&] {
    if (samples == nullptr) throw usage_error("samples", "is a null pointer", "their number");
    const Trajectory trajectory = read_trajectory(valid(results), run);
    auto* numbers = owned_array<double>(trajectory.samples.size() * Sample::kNumbers);
    double* next = numbers;
    for (const Sample& sample : trajectory.samples)
      for (const double number : sample.numbers()) *next++ = number;
    *samples = trajectory.samples.size();
    return numbers;
  });
}

slalom_scenarios* slalom_results_scenarios(const slalom_results* results) {
  return guarded<slalom_scenarios*>(
      nullptr, [&] { return new slalom_scenarios{scenarios_of(valid(results))}; });
}

slalom_results* slalom_results_add(const slalom_results* results, const char* column,
                                   const char* path) {
  return guarded<slalom_results*>(nullptr, [&] {
    const std::string file = text_of(path, "path");
    return new slalom_results{add_column(valid(results), json_of(column, "column"), file), file,
                              nullptr};
  });
}

char* slalom_results_html(const slalom_results* results) {
  return text_about(results, [](const slalom_results& given) {
    return first_screen(given.path, given.table, report_options(given.table));
  });
}

char* slalom_results_summary(const slalom_results* results) {
  return text_about(results, summarize);
}

char* slalom_results_table(const slalom_results* results, const char* rows, const char* columns,
                           double confidence) {
  return text_about(results, [&](const slalom_results& given) {
    return cross_table(given.table, text_of(rows, "rows"), json_of(columns, "columns"), confidence);
  });
}

int slalom_results_save(const slalom_results* results, const char* path) {
  return guarded(-1, [&] {
    save(path_of(valid(results)), text_of(path, "path"));
    return 0;
  });
}
