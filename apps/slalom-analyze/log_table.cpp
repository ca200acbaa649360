// SPDX-License-Identifier: BSD-3-Clause
#include "log_table.h"
#include "name_pattern.h"
#include "output.h"

#include <slalom/analysis/data_table.h>
#include <slalom/bags/bag.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_list.h>
#include <slalom/io/scenario_yaml.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// The scenarios of logs by name; keeps the world of the last one.
class LogScenarios {
 public:
  LogScenarios(const LogTableArguments& arguments, double resolution)
      : path_(arguments.scenarios), single_(arguments.scenario), resolution_(resolution) {
    std::error_code ignored;
    if (!single_.empty())
      world("");
    else if (!fs::is_directory(path_, ignored))
      list_.emplace(ScenarioList::open(path_));
  }

  bool is_known(const std::string& name) const {
    if (!single_.empty()) return true;
    if (!list_) return !file_of(name).empty();
    try {
      list_->find_entry(name);
      return true;
    } catch (const Error&) {
      return false;
    }
  }

  /// Throws Error (File) if there is no such scenario.
  const World& world(const std::string& name) {
    if (world_ && (name == name_ || !single_.empty())) return *world_;
    world_.emplace(scenario(name), resolution_);
    name_ = name;
    return *world_;
  }

 private:
  std::string path_, single_;
  double resolution_;
  std::optional<ScenarioList> list_;
  std::optional<World> world_;
  std::string name_;

  std::string file_of(const std::string& name) const {
    for (const char* extension : {".yaml", ".yml"})
      if (const std::string file = (fs::path(path_) / (name + extension)).string();
          fs::exists(file))
        return file;
    return "";
  }

  Scenario scenario(const std::string& name) const {
    if (!single_.empty()) return load_scenario_yaml(single_);
    if (!is_known(name))
      throw file_error(path_, "no scenario '" + name + "'",
                       list_ ? "the name of a scenario of the list" : name + ".yaml in the folder");
    return list_ ? list_->read(list_->find_entry(name).hash) : load_scenario_yaml(file_of(name));
  }
};

struct LogFile {
  std::string path;
  NamePattern::Fields fields;
};

/// A run of a log, or why it was refused.
struct RunRow {
  std::string log;
  NamePattern::Fields fields;
  std::optional<EvaluatedLog> run;
  std::string refusal;
};

bool has_name_of_log(const std::string& path) {
  for (const char* extension : {".csv", ".tsv", ".txt", ".tum", ".bag", ".mcap", ".db3"})
    if (ends_with(lower_case(path), extension)) return true;
  return false;
}

std::vector<std::string> files_below(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::recursive_directory_iterator file(folder, error), end; !error && file != end;
       file.increment(error))
    if (file->is_regular_file(error)) files.push_back(file->path().string());
  if (error) throw file_error(folder, "cannot be read: " + error.message(), "a folder with logs");
  std::sort(files.begin(), files.end());
  return files;
}

/// Finds the logs, and what their names say.
class LogFiles {
 public:
  LogFiles(const LogTableArguments& arguments, const std::optional<NamePattern>& pattern,
           const LogScenarios& scenarios)
      : pattern_(pattern), scenarios_(scenarios) {
    std::error_code ignored;
    for (const std::string& path : arguments.logs) {
      if (is_bag(path) || !fs::is_directory(path, ignored)) {
        if (!add(path))
          throw usage_error("--name-pattern", "does not match " + path, "a name that matches");
        continue;
      }
      const std::size_t before = ways_.size();
      for (const std::string& file : files_below(path))
        left_out_ += (pattern_ || has_name_of_log(file)) && add(file) ? 0 : 1;
      if (ways_.size() == before)
        throw file_error(path, pattern_ ? "no file that matches --name-pattern" : "no logs",
                         "files as .csv, .tsv, .txt, .tum, .bag, .mcap or .db3");
    }
  }

  std::size_t left_out() const { return left_out_; }

  /// Throws Error (Usage) for a name that can be read in several ways.
  std::vector<LogFile> files() const {
    std::vector<std::string> methods;
    for (const auto& [path, ways] : ways_)
      if (ways.size() == 1 && ways[0].count("method") > 0) methods.push_back(ways[0].at("method"));
    std::vector<LogFile> files;
    for (auto [path, ways] : ways_) {
      keep(ways, "method", [&](const std::string& name) { return contains(methods, name); });
      if (ways.size() > 1)
        throw usage_error("--name-pattern",
                          path + " can be read in " + std::to_string(ways.size()) +
                              " ways: " + text_of(ways[0]) + "; " + text_of(ways[1]),
                          "other characters between the fields, or a folder for each method");
      files.push_back({path, ways[0]});
    }
    return files;
  }

 private:
  const std::optional<NamePattern>& pattern_;
  const LogScenarios& scenarios_;
  std::vector<std::pair<std::string, std::vector<NamePattern::Fields>>> ways_;  ///< by path
  std::size_t left_out_ = 0;

  /// False if the name does not match.
  bool add(const std::string& path) {
    std::vector<NamePattern::Fields> ways(1);
    if (pattern_) ways = pattern_->matches(path);
    if (ways.empty()) return false;
    keep(ways, "scenario", [&](const std::string& name) { return scenarios_.is_known(name); });
    ways_.emplace_back(path, std::move(ways));
    return true;
  }

  /// Leaves, of several ways, those whose field is known, if there are any.
  template <typename IsKnown>
  static void keep(std::vector<NamePattern::Fields>& ways, const std::string& field,
                   IsKnown is_known) {
    if (ways.size() < 2 || ways[0].count(field) == 0) return;
    const auto known = std::stable_partition(
        ways.begin(), ways.end(), [&](const auto& fields) { return is_known(fields.at(field)); });
    if (known != ways.begin()) ways.erase(known, ways.end());
  }

  static std::string text_of(const NamePattern::Fields& fields) {
    std::vector<std::string> parts;
    for (const auto& [field, value] : fields) parts.push_back(field + " " + value);
    return join(parts, ", ");
  }
};

/// Counts in how many logs there is a note, and prints each once.
class Notes {
 public:
  void add(const std::string& log, const std::vector<std::string>& notes) {
    for (const std::string& note : notes) {
      auto& [first, others] = notes_[note];
      others += first.empty() ? 0 : 1;
      if (!first.empty()) continue;
      order_.push_back(note);
      first = log;
    }
  }

  void print() const {
    for (const std::string& note : order_) {
      const auto& [first, others] = notes_.at(note);
      std::cerr << first << (others > 0 ? " and " + count_text(others, "other run") : "") << ": "
                << note << "\n";
    }
  }

 private:
  std::map<std::string, std::pair<std::string, std::size_t>> notes_;
  std::vector<std::string> order_;
};

std::string reasons_of(const RunRow& row) {
  if (!row.run) return row.refusal;
  std::vector<std::string> parts;
  for (const auto& [id, versioned] : row.run->metrics)
    if (versioned.value.is_na()) parts.push_back(id + ": " + versioned.value.reason());
  return join(parts, "; ");
}

Field metric_of(const RunRow& row, const std::string& id) {
  if (!row.run) return {};
  const auto found = row.run->metrics.find(id);
  if (found == row.run->metrics.end() || found->second.value.is_na()) return {};
  return found->second.value.number();
}

/// The table of rows; they must outlive it.
DataTable table_of(const std::vector<RunRow>& rows, const std::vector<std::string>& keys) {
  DataTable table;
  table.rows = rows.size();
  table.columns = keys;
  table.columns.insert(table.columns.begin(), "log");
  table.columns.emplace_back("outcome");
  const std::size_t first = table.columns.size();
  for (const RunRow& row : rows)
    if (row.run)
      for (const auto& [id, value] : row.run->metrics)
        if (!contains(table.columns, id)) table.columns.push_back(id);
  std::sort(table.columns.begin() + static_cast<std::ptrdiff_t>(first), table.columns.end());
  table.columns.emplace_back("na_reasons");
  table.at = [&rows, columns = table.columns, first](std::size_t index, std::size_t column) {
    const RunRow& row = rows[index];
    if (column == 0) return Field(row.log);
    if (column + 1 == columns.size()) return Field(reasons_of(row));
    if (column >= first) return metric_of(row, columns[column]);
    if (column + 1 == first) return row.run ? Field(to_string(row.run->run.outcome)) : Field();
    const auto field = row.fields.find(columns[column]);
    return field == row.fields.end() ? Field() : Field(field->second);
  };
  return table;
}

void require_arguments(const LogTableArguments& arguments,
                       const std::optional<NamePattern>& pattern) {
  if (arguments.scenario.empty() == arguments.scenarios.empty())
    throw usage_error("--scenario", arguments.scenario.empty() ? "missing" : "and --scenarios",
                      "--scenario FILE for all logs, or --scenarios FOLDER or LIST");
  if (!arguments.scenarios.empty() && !(pattern && pattern->has("scenario")))
    throw usage_error("--scenarios", "without {scenario} in --name-pattern",
                      "such as --name-pattern {method}_{scenario}.csv");
  if (arguments.split && pattern && pattern->has("repetition"))
    throw usage_error("--split", "with {repetition} in --name-pattern",
                      "the repetition of a run is its number in the log");
}

/// Measures the runs of logs one by one.
class LogMeasurement {
 public:
  LogMeasurement(LogScenarios& scenarios, const ReadRuns& read, const MeasureRun& measure)
      : scenarios_(scenarios), read_(read), measure_(measure) {}

  void add(const LogFile& log, bool split) {
    NamePattern::Fields fields = log.fields;
    try {
      const World& world = scenarios_.world(fields["scenario"]);
      if (fields["scenario"].empty()) fields["scenario"] = world.scenario().name();
      std::size_t number = 0;
      for (const TrajectoryFile& run : read_(log.path)) {
        if (split) fields["repetition"] = std::to_string(++number);
        EvaluatedLog evaluated = measure_(world, run.trajectory);
        notes_.add(log.path, run.notes);
        notes_.add(log.path, evaluated.notes);
        rows_.push_back({log.path, fields, std::move(evaluated), ""});
      }
    } catch (const Error& error) {
      rows_.push_back({log.path, fields, std::nullopt, error.what()});
      refused_.push_back(error.what());
    }
  }

  const std::vector<RunRow>& rows() const { return rows_; }
  const std::vector<std::string>& refused() const { return refused_; }
  const Notes& notes() const { return notes_; }

 private:
  LogScenarios& scenarios_;
  const ReadRuns& read_;
  const MeasureRun& measure_;
  std::vector<RunRow> rows_;
  std::vector<std::string> refused_;
  Notes notes_;
};

}  // namespace

void print_log_table(const LogTableArguments& arguments, double resolution, const ReadRuns& read,
                     const MeasureRun& measure) {
  std::optional<NamePattern> pattern;
  if (!arguments.name_pattern.empty()) pattern.emplace(arguments.name_pattern);
  require_arguments(arguments, pattern);
  LogScenarios scenarios(arguments, resolution);
  const LogFiles logs(arguments, pattern, scenarios);
  LogMeasurement measurement(scenarios, read, measure);
  const std::vector<LogFile> files = logs.files();
  for (const LogFile& log : files) measurement.add(log, arguments.split);
  std::vector<std::string> keys;
  for (const char* key : {"method", "scenario", "repetition"})
    if (std::string(key) == "scenario" || (pattern && pattern->has(key)) ||
        (arguments.split && std::string(key) == "repetition"))
      keys.emplace_back(key);
  print_or_write(render_csv(table_of(measurement.rows(), keys)), arguments.output);
  if (!arguments.quiet) {
    measurement.notes().print();
    if (logs.left_out() > 0)
      std::cerr << count_text(logs.left_out(), "file") << " left out: "
                << (pattern ? "the name does not match --name-pattern" : "no name of a log")
                << "\n";
  }
  for (const std::string& reason : measurement.refused()) std::cerr << reason << "\n";
  if (!measurement.refused().empty())
    throw job_error("metrics", std::to_string(measurement.refused().size()) + " of " +
                                   count_text(files.size(), "log") + " refused");
}

}  // namespace slalom
