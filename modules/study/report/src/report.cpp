// SPDX-License-Identifier: BSD-3-Clause
#include "index_page.h"
#include "leaderboard.h"
#include "pages.h"
#include "report_data.h"
#include "scenario_data.h"
#include "value_data.h"

#include <slalom/analysis/analysis_section.h>
#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>
#include <slalom/io/result_files.h>
#include <slalom/report/report.h>
#include <slalom/results/privileged.h>
#include <slalom/results/recorded_ini.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

namespace slalom {
namespace {

constexpr std::size_t kMaxPicturesPerPage = 200;
constexpr std::size_t kMaxFailurePictures = 24;
constexpr std::size_t kMaxBytesPerPage = 6u << 20u;

/// The file with the pictures of a page, from 1.
std::string pictures_file(std::size_t page) {
  return "data/pictures-" + std::to_string(page) + ".js";
}

/// The campaign .ini from the manifest; empty if it cannot be parsed.
IniFile campaign_ini(const Manifest& manifest) {
  try {
    return recorded_ini(manifest, "campaign.ini");
  } catch (const Error&) {
    return IniFile::from_text("");
  }
}

/// Bins by density if any scenario has it.
std::vector<BinSpec> default_rows(const ResultTable& runs) {
  const ValueColumn* density = find_descriptor(runs, "density");
  for (std::size_t i = 0; density != nullptr && i < density->size(); ++i)
    if (!density->is_na(i)) return {parse_bin_spec("density:q4")};
  return {BinSpec{}};
}

/// The three metrics of "Advances in the Framework for Automatic Evaluation of Obstacle Avoidance
/// Methods", as far as the results contain them;
/// else the first one.
std::vector<std::string> default_columns(const ResultTable& runs) {
  std::vector<std::string> columns;
  for (const char* id : {"success", "optimality", "safety"})
    if (find_metric(runs, id) != nullptr) columns.emplace_back(id);
  if (columns.empty())
    columns.push_back(runs.metrics.empty() ? "success" : runs.metrics[0].info().id);
  return columns;
}

/// Writes the files of the scenarios, and collects the parts of report.json that grow with their
/// number: "scenarios" and "runs".
class ScenarioFiles {
 public:
  ScenarioFiles(const std::string& results, const ReportInput& input, const std::string& directory)
      : files_(results),
        input_(input),
        runs_(input.runs),
        directory_(directory),
        facts_(input.runs.methods.size(), input.options.robot) {
    for (const MethodOverview& method : input.overview)
      for (const NotableFailure& failure : method.failures)
        if (notable_.size() < kMaxFailurePictures) notable_.insert(failure.run);
    for (const std::string& outcome : runs_.outcomes) {
      const auto& names = input.summary.outcomes;
      outcomes_.push_back(std::find(names.begin(), names.end(), outcome) - names.begin());
    }
    for (const Column& column : input.summary.columns)
      columns_.push_back(find_metric(runs_, column.info.id));
  }

  OrderedJson write() {
    for (std::size_t scenario = 0; scenario < runs_.scenario_hashes.size(); ++scenario)
      add(scenario);
    write_pictures();
    write_file_atomically((directory_ / "data" / "failures.js").string(),
                          "slalomFailures(" + json_text(failure_pictures_) + ");\n");
    return {{"scenarios", std::move(scenarios_)}, {"runs", std::move(entries_)}};
  }

  /// Facts that failures have in common; call it after write().
  const CommonFacts& facts() const { return facts_; }

 private:
  ResultFiles files_;
  const ReportInput& input_;
  const ResultTable& runs_;
  std::filesystem::path directory_;
  std::vector<std::ptrdiff_t> outcomes_;  ///< indexes into the report's outcomes
  std::vector<const ValueColumn*> columns_;
  OrderedJson scenarios_ = OrderedJson::array(), entries_ = OrderedJson::array();
  OrderedJson pictures_ = OrderedJson::array();           ///< of the current page
  std::set<std::size_t> notable_;                         ///< runs on the first screen
  OrderedJson failure_pictures_ = OrderedJson::object();  ///< by their index
  std::size_t page_ = 1, page_bytes_ = 0;
  CommonFacts facts_;

  /// Scenarios are in the order of their runs.
  void add(std::size_t scenario) {
    const std::string& hash = runs_.scenario_hashes[scenario];
    const std::size_t first = entries_.size();
    std::vector<std::string> details;
    std::string picture;
    const auto files =
        is_imported(runs_.manifest) ? std::vector<const ResultFile*>() : files_.with_scenario(hash);
    if (!files.empty()) {
      const ScenarioRuns content = read_scenario_runs(files, runs_, scenario, first);
      const World world(content.content, input_.options.simulation.resolution);
      write_file_atomically((directory_ / "data" / ("s-" + hash.substr(0, 8) + ".js")).string(),
                            scenario_script(input_, content, world, directory_.string()));
      picture = scenario_picture(input_, content);
      for (std::size_t i = 0; i < content.records.size(); ++i) {
        details.push_back(content.records[i].outcome_detail);
        facts_.add(runs_.method[first + i], content, world, i);
        if (notable_.count(first + i) > 0)
          failure_pictures_[std::to_string(first + i)] = failure_picture(input_, content, i);
      }
    }
    for (std::size_t run = first; run < runs_.size() && runs_.scenario[run] == scenario; ++run)
      entries_.push_back(entry(run, run - first < details.size() ? details[run - first] : ""));
    add_picture(picture);
    OrderedJson values = OrderedJson::array();
    for (const ValueColumn& column : runs_.descriptors)
      values.push_back(rounded_json(column, scenario));
    scenarios_.push_back({{"hash", hash},
                          {"name", runs_.scenario_names[scenario]},
                          {"page", page_},
                          {"values", values}});
  }

  OrderedJson entry(std::size_t run, const std::string& detail) const {
    OrderedJson json = {runs_.scenario[run], runs_.method[run], runs_.repetition[run],
                        outcomes_[runs_.outcome[run]], detail};
    for (const ValueColumn* column : columns_) json.push_back(rounded_json(*column, run));
    return json;
  }

  void add_picture(const std::string& picture) {
    const bool full =
        pictures_.size() == kMaxPicturesPerPage || page_bytes_ + picture.size() > kMaxBytesPerPage;
    if (full && !pictures_.empty()) {
      write_pictures();
      pictures_.clear();
      page_bytes_ = 0;
      ++page_;
    }
    pictures_.push_back(picture);
    page_bytes_ += picture.size();
  }

  void write_pictures() const {
    write_file_atomically(
        (directory_ / pictures_file(page_)).string(),
        "slalomPictures(" + std::to_string(page_) + "," + json_text(pictures_) + ");\n");
  }
};

OrderedJson groups_json(const std::vector<RunGroup>& groups) {
  OrderedJson json = OrderedJson::array();
  for (const RunGroup& group : groups)
    json.push_back({{"title", group.title}, {"runs", group.runs}});
  return json;
}

void make_directory(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(directory) / "data", error);
  if (error)
    throw job_error(directory, "cannot be created: " + error.message(), "a writable folder");
}

}  // namespace

ReportOptions report_options(const ResultTable& runs) {
  const IniFile ini = campaign_ini(runs.manifest);
  ReportOptions options;
  const auto section = read_options<AnalysisSection>(ini, "analysis");
  options.rows = section.rows.empty() ? default_rows(runs) : parse_bin_specs(section.rows);
  options.columns = section.columns.empty() ? default_columns(runs) : split(section.columns, ',');
  options.analysis.confidence = section.confidence;
  options.focus = section.focus;
  options.robot = read_robot_model(ini);
  options.sensor = read_sensor_model(ini);
  options.simulation = read_options<SimulationOptions>(ini, "simulation");
  options.people = read_options<PeopleSettings>(ini, "people");
  long long seed = 1;
  parse_integer(ini.get("campaign", "seed").value_or("1"), seed);
  options.seed = static_cast<std::uint64_t>(seed);
  options.generates = !ini.get("scenarios", "generator").value_or("").empty();
  return options;
}

void write_report(const std::string& results, ResultTable runs, const ReportOptions& options,
                  const std::string& directory) {
  mark_privileged(runs);
  ReportInput input = make_report_input(runs, options);
  add_method_failures(runs, results, input.failures);
  std::vector<RunGroup> groups;
  OrderedJson data = report_data(input, groups);
  data["results"] = std::filesystem::path(results).lexically_normal().filename().string();
  make_directory(directory);
  ScenarioFiles files(results, input, directory);
  OrderedJson lists = files.write();
  for (OrderedJson& entry : data["overview"])
    if (const auto common = files.facts().of(entry["method"].get<std::size_t>()))
      entry["in_common"] = {
          {"failures", common->failures}, {"runs", common->count}, {"text", common->text}};
  std::vector<std::string> headlines;
  for (const OrderedJson& line : data["headlines"]) headlines.push_back(line["text"]);
  const Leaderboard leaderboard(input, files.facts());
  const std::string summary = json_text(data);
  lists["groups"] = groups_json(groups);
  const std::string runs_text = json_text(lists), values = json_text(value_data(runs));
  const auto write = [&directory](const std::string& name, const std::string& text) {
    write_file_atomically((std::filesystem::path(directory) / name).string(), text);
  };
  write("data/summary.js", "slalomReport(" + summary + ");\n");
  write("data/runs.js", "slalomReport(" + runs_text + ");\n");
  write("data/values.js", "slalomReport(" + values + ");\n");
  // One object with the fields of all.
  write("report.json", summary.substr(0, summary.size() - 1) + "," +
                           runs_text.substr(1, runs_text.size() - 2) + "," + values.substr(1) +
                           "\n");
  for (const auto& [name, text] : report_pages())
    if (!starts_with(name, "packed.") && (name != "cluster.html" || !options.clusters.empty()))
      write(name, name == "index.html" ? index_page(text, input, leaderboard, headlines) : text);
}

std::string first_screen(const std::string& results, ResultTable runs,
                         const ReportOptions& options) {
  mark_privileged(runs);
  ReportInput input = make_report_input(runs, options);
  if (!results.empty()) add_method_failures(runs, results, input.failures);
  const CommonFacts facts(runs.methods.size(), options.robot);
  const Leaderboard leaderboard(input, facts);
  const auto& pages = report_pages();
  const std::string& page = pages.at("index.html");
  std::string screen = page.substr(0, page.find("<nav ")) + "</body>\n</html>\n";
  const std::string link = "<link rel=\"stylesheet\" href=\"report.css\">";
  screen.replace(screen.find(link), link.size(),
                 "<style>" + pages.at("report.css") +
                     " .failures { display: none !important } a { color: inherit; pointer-events: "
                     "none }</style>");
  return index_page(screen, input, leaderboard, {});
}

void remove_report(const std::string& directory) {
  const auto removed = [&directory](const std::string& name) {
    std::error_code error;
    const auto path = std::filesystem::path(directory) / name;
    if (std::filesystem::remove(path, error)) return true;
    if (error) throw job_error(path.string(), "cannot be removed: " + error.message());
    return false;
  };
  for (const std::string name : {"data/summary.js", "data/runs.js", "report.json"}) removed(name);
  for (std::size_t page = 1; removed(pictures_file(page));) ++page;
  for (const auto& [name, text] : report_pages()) removed(name);
}

}  // namespace slalom
