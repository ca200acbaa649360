// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark_table.h"

#include <slalom/analysis/table_export.h>
#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/io/foreign_database.h>
#include <slalom/io/read_results.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace slalom {
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kMaxJsonSize = 200 * kMegabyte;

std::string csv_line(const std::vector<std::string>& fields) {
  std::vector<std::string> quoted;
  for (const std::string& field : fields) quoted.push_back(csv_field(field));
  return join(quoted, ",") + "\n";
}

/// The tables of ompl_benchmark_statistics.py.
class OmplDatabase {
 public:
  explicit OmplDatabase(SQLite::Database& database) : database_(database) {}

  bool is_one() const {
    return database_
               .execAndGet(
                   "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name IN "
                   "('experiments', 'plannerConfigs', 'enums', 'runs')")
               .getInt() == 4;
  }

  BenchmarkTable read() {
    read_descriptions();
    find_columns();
    std::vector<std::string> names = {"scenario", "method"};
    // A run whose experiment or planner is missing counts, too.
    std::vector<std::string> selected = {
        "coalesce(e.name, 'experiment ' || ifnull(r.experimentid, ''))",
        "coalesce(p.name, 'planner ' || ifnull(r.plannerid, ''))"};
    for (const std::string& column : columns_) {
      names.push_back(column == "status" ? "outcome" : plain(column));
      selected.push_back("r.\"" + column + "\"");
    }
    std::string csv = csv_line(names);
    SQLite::Statement rows(database_, "SELECT " + join(selected, ", ") +
                                          " FROM runs r LEFT JOIN experiments e ON e.id = "
                                          "r.experimentid LEFT JOIN plannerConfigs p ON p.id = "
                                          "r.plannerid ORDER BY r.id");
    while (rows.executeStep()) {
      std::vector<std::string> fields = {rows.getColumn(0).getString(),
                                         rows.getColumn(1).getString()};
      for (std::size_t i = 0; i < columns_.size(); ++i)
        fields.push_back(text_of(columns_[i], rows.getColumn(static_cast<int>(i) + 2)));
      csv += csv_line(fields);
    }
    return {csv, {"exact solution"}};
  }

 private:
  static std::string plain(std::string name) {
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  }

  void read_descriptions() {
    SQLite::Statement rows(database_, "SELECT name, value, description FROM enums");
    while (rows.executeStep())
      descriptions_[rows.getColumn(0).getString()][rows.getColumn(1).getInt64()] =
          rows.getColumn(2).getString();
  }

  void find_columns() {
    SQLite::Statement rows(database_, "SELECT name FROM pragma_table_info('runs')");
    while (rows.executeStep()) {
      const std::string name = rows.getColumn(0).getString();
      const bool is_id = name == "id" || name == "experimentid" || name == "plannerid";
      if (!is_id && name.find('"') == std::string::npos) columns_.push_back(name);
    }
  }

  std::string text_of(const std::string& name, const SQLite::Column& value) const {
    if (value.isNull()) return "";
    const auto words = descriptions_.find(name);
    if (words != descriptions_.end() && value.isInteger()) {
      const auto word = words->second.find(value.getInt64());
      if (word != words->second.end()) return word->second;
    }
    return value.isFloat() ? format_number(value.getDouble()) : value.getString();
  }

  SQLite::Database& database_;
  std::map<std::string, std::map<std::int64_t, std::string>> descriptions_;
  std::vector<std::string> columns_;
};

std::optional<BenchmarkTable> read_ompl_database(const std::string& path) {
  const auto file = open_foreign_database(path, "a benchmark database of OMPL");
  try {
    OmplDatabase database(*file);
    if (!database.is_one()) return std::nullopt;
    return database.read();
  } catch (const SQLite::Exception& e) {
    throw file_error(path, std::string("cannot be read: ") + e.what(),
                     "a benchmark database of OMPL");
  }
}

/// A number, 1 or 0, or the length of a list; empty for anything else.
std::string value_text(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  if (value.is_number()) return format_number(value.get<double>());
  return value.is_array() ? std::to_string(value.size()) : "";
}

bool is_true(const Json& stats, const char* key) {
  const auto found = stats.find(key);
  return found != stats.end() && found->is_boolean() && found->get<bool>();
}

std::string outcome_of(const Json& stats) {
  if (!is_true(stats, "path_found")) return "failure";
  if (is_true(stats, "path_collides")) return "collision";
  return is_true(stats, "exact_goal_path") ? "success" : "failure";
}

std::string environment_of(const Json& run) {
  const auto environment = run.find("environment");
  if (environment == run.end() || !environment->is_object()) return "environment";
  const auto name = environment->find("name");
  return name != environment->end() && name->is_string() ? name->get<std::string>() : "environment";
}

/// Calls use(environment, planner, stats) for each plan; one without stats has none of them.
template <typename Use>
void for_each_plan(const Json& runs, Use use) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Json& run = runs[i];
    const std::string environment = environment_of(run) + " " + std::to_string(i);
    const auto plans = run.find("plans");
    if (plans == run.end() || !plans->is_object()) continue;
    for (const auto& [planner, plan] : plans->items()) {
      const bool has_stats =
          plan.is_object() && plan.contains("stats") && plan["stats"].is_object();
      use(environment, planner, has_stats ? plan["stats"] : Json::object());
    }
  }
}

bool is_bench_mr(const Json& file) {
  const auto runs = file.find("runs");
  return file.is_object() && runs != file.end() && runs->is_array() && !runs->empty() &&
         std::all_of(runs->begin(), runs->end(), [](const Json& run) { return run.is_object(); }) &&
         runs->front().contains("plans");
}

}  // namespace

std::optional<BenchmarkTable> bench_mr_from_text(const std::string& text) {
  const Json file = Json::parse(text, nullptr, false);
  if (!is_bench_mr(file)) return std::nullopt;
  std::vector<std::string> keys;
  for_each_plan(file["runs"], [&](const std::string&, const std::string&, const Json& stats) {
    for (const auto& [key, value] : stats.items())
      if (!value.is_string() && !value.is_object() && !contains(keys, key)) keys.push_back(key);
  });
  std::vector<std::string> names = {"scenario", "method", "outcome"};
  names.insert(names.end(), keys.begin(), keys.end());
  std::string csv = csv_line(names);
  for_each_plan(file["runs"],
                [&](const std::string& environment, const std::string& planner, const Json& stats) {
                  std::vector<std::string> fields = {environment, planner, outcome_of(stats)};
                  for (const std::string& key : keys)
                    fields.push_back(stats.contains(key) ? value_text(stats[key]) : "");
                  csv += csv_line(fields);
                });
  return BenchmarkTable{csv, {}};
}

std::optional<BenchmarkTable> read_benchmark_table(const std::string& path) {
  if (is_database(path)) return read_ompl_database(path);
  if (!ends_with(path, ".json")) return std::nullopt;
  return bench_mr_from_text(read_text(path, "results of Bench-MR", kMaxJsonSize));
}

}  // namespace slalom
