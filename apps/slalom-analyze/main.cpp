// SPDX-License-Identifier: BSD-3-Clause
#include "export.h"
#include "figure.h"
#include "history_report.h"
#include "import_table.h"
#include "interpret.h"
#include "key_options.h"
#include "metrics.h"
#include "output.h"
#include "registry.h"
#include "show.h"
#include "sim2real.h"
#include "trajectories.h"
#include "warnings.h"

#include <slalom/app/campaign_names.h>
#include <slalom/app/checks.h>
#include <slalom/app/completion.h>
#include <slalom/app/program.h>
#include <slalom/campaign/campaign_options.h>
#include <slalom/core/read_file.h>
#include <slalom/core/scratch_folder.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/falsification/cluster_report.h>
#include <slalom/io/find_run.h>
#include <slalom/io/imported_table.h>
#include <slalom/io/rawlog_path.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/report/report.h>
#include <slalom/tables/analysis_input.h>

#include <filesystem>
#include <iostream>
#include <optional>

namespace slalom {
namespace {

/// Command-line arguments of all verbs.
struct Arguments {
  std::vector<std::string> all_results;  ///< of report
  std::string results, rows, columns, output, run;
  CsvColumnOptions table;  ///< of tables
  double confidence = 0;   ///< 0: that of the campaign
  bool json = false, quiet = false, single_file = false, despite_settings = false;
};

CLI::App* add_verb(CLI::App& app, const std::string& name, const std::string& help,
                   Arguments& arguments) {
  CLI::App* verb = app.add_subcommand(name, help);
  verb->add_option("results", arguments.results, "A result file (.results)")->required();
  return verb;
}

void add_table_options(CLI::App& verb, Arguments& arguments) {
  complete_with(
      verb.add_option("--rows", arguments.rows,
                      "Bins of a scenario descriptor: all, ID (quarters), ID:EDGE,EDGE,..., "
                      "ID:COUNT (equal width) or ID:qCOUNT (quantiles), such as "
                      "density:0,0.1,0.2 or density:q4; several separated by ';' (default: the "
                      "campaign's [analysis])"),
      [](const Words&) { return descriptor_ids(); });
  complete_with(verb.add_option("--columns", arguments.columns,
                                "Metric ids, comma-separated (default: the campaign's [analysis])"),
                [](const Words&) { return metric_ids(); });
  verb.add_option("--confidence", arguments.confidence, "Confidence of intervals, e.g. 0.95")
      ->check(in_range(0.5, 0.9999));
}

/// The options of the campaign, overridden by the command line.
ReportOptions effective_options(const ResultTable& runs, const Arguments& arguments) {
  ReportOptions options = report_options(runs);
  options.planned_runs = planned_runs(runs);
  if (!arguments.rows.empty()) options.rows = parse_bin_specs(arguments.rows, "--rows");
  if (!arguments.columns.empty()) options.columns = split(arguments.columns, ',');
  if (arguments.confidence > 0) options.analysis.confidence = arguments.confidence;
  return options;
}

/// The results of a folder of slalom-falsify are the runs that it has examined.
std::string reported_path(const std::string& path) {
  const std::filesystem::path folder(path);
  const bool is_examined = std::filesystem::exists(folder / kExaminedFailures);
  return is_examined ? (folder / kExaminedResults).string() : path;
}

/// Path of the failures that slalom-falsify has examined in these results; empty if it did not
/// write them.
std::string examined_path(std::filesystem::path results) {
  results.replace_extension(".json");
  const bool exists = results.filename() == kExaminedFailures && std::filesystem::exists(results);
  return exists ? results.string() : "";
}

void report_one(const std::string& path, const ResultTable& runs, const std::string& folder,
                const Arguments& arguments) {
  ReportOptions options = effective_options(runs, arguments);
  const std::string examined = examined_path(path);
  if (!examined.empty())
    options.clusters = explain_failures(
        ResultFile::open(path), runs, options,
        examined_failures_from_json(read_text(examined, "examined failures"), examined));
  write_report(path, runs, options, folder);
}

void report_several(const std::vector<std::string>& paths, const std::vector<ResultTable>& results,
                    const std::string& output, const Arguments& arguments) {
  AnalysisRequest request;
  request.rows = arguments.rows;
  request.metrics = arguments.columns;
  request.confidence = arguments.confidence;
  request.despite_settings = arguments.despite_settings;
  report_history(paths, results, request, output, [&](std::size_t i, const std::string& folder) {
    report_one(paths[i], results[i], folder, arguments);
  });
}

void report_verb(const Arguments& arguments) {
  const ScratchFolder imported;
  std::vector<std::string> paths;
  std::vector<ResultTable> results;
  for (const std::string& path : arguments.all_results) {
    paths.push_back(reported_path(path));
    if (!is_result_input(path) && !ends_with(path, ".results")) {
      const ResultTable table = read_analysis_input(path, std::nullopt, true, arguments.table);
      warn_of_missing(path, table);
      paths.back() = imported.path() + "/" + std::to_string(paths.size()) + ".results";
      write_imported(table, paths.back());
    }
    results.push_back(read_results(paths.back()));
    if (is_imported(results.back().manifest)) sort_rows(results.back());  // they have their order
    warn_of_missing(paths.back(), results.back());
  }
  const std::filesystem::path output = arguments.output;
  const bool is_packed = arguments.single_file || output.extension() == ".html";
  std::optional<ScratchFolder> scratch;
  const std::string folder = is_packed ? scratch.emplace().path() : output.string();
  if (paths.size() == 1)
    report_one(paths[0], results[0], folder, arguments);
  else
    report_several(paths, results, folder, arguments);
  if (is_packed) write_file_atomically(output.string(), packed_report(folder));
  if (arguments.quiet) return;
  std::cerr << "report: " << (is_packed ? output : output / "index.html").string() << "\n";
}

void show_verb(const Arguments& arguments) {
  const ResultFile file = ResultFile::open(arguments.results);
  const RunRecord run = find_run(file, arguments.run);
  if (arguments.json) {
    const ScenarioRecord scenario = file.read_record(run.scenario_hash);
    std::cout << dump_line(file.read_manifest()["campaign"], scenario, run) << "\n";
    return;
  }
  std::cout << run_text(file, run);
  const std::string rawlog =
      rawlog_path(arguments.results, run.scenario_hash, run.method, run.repetition);
  if (std::filesystem::exists(rawlog))
    std::cout << "rawlog, see slalom-replay\n  " << rawlog << "\n";
  const std::string bag =
      bag_path(arguments.results, run.scenario_hash, run.method, run.repetition);
  if (std::filesystem::exists(bag)) std::cout << "bag of ROS 2\n  " << bag << "\n";
}

void dump_verb(const Arguments& arguments) {
  const ResultFile file = ResultFile::open(arguments.results);
  std::vector<std::string> damaged;
  const auto report = [&](const std::string& what) { damaged.push_back(what); };
  print_or_write([&](std::ostream& out) { dump(file, out, report); }, arguments.output);
  warn_of_damage(arguments.results, damaged);
}

void define_report(CLI::App& app, Arguments& arguments) {
  CLI::App* verb = app.add_subcommand("report", "Write a self-contained HTML report");
  verb->add_option(
          "results", arguments.all_results,
          "A result file (.results), a folder with the shards of a campaign, a table (.csv), or a "
          "folder of slalom-falsify, whose clusters of failures are reported as well; several, "
          "such as those of successive versions: a report of each, and what changed")
      ->required();
  add_table_options(*verb, arguments);
  add_key_options(*verb, arguments.table, false);
  verb->add_option("-o,--output", arguments.output,
                   "Folder to write to, or a file FILE.html that contains all of it, for mail")
      ->required();
  verb->add_flag("--single-file", arguments.single_file, "One file, whatever the name of --output");
  verb->add_flag("--despite-settings", arguments.despite_settings,
                 "Several files: verdicts also of campaigns that differ in other settings");
  verb->add_flag("--quiet", arguments.quiet, "No messages");
  verb->callback([&arguments] { report_verb(arguments); });
}

void define_show(CLI::App& app, Arguments& arguments) {
  CLI::App* verb = add_verb(app, "show", "Print all data of one run", arguments);
  verb->add_option("--run", arguments.run, "The run: SCENARIO/METHOD/REPETITION")->required();
  verb->add_flag("--json", arguments.json, "JSON, in the format of dump");
  verb->callback([&arguments] { show_verb(arguments); });
}

void define_dump(CLI::App& app, Arguments& arguments) {
  CLI::App* verb =
      add_verb(app, "dump", "Print all deterministic values as JSON lines, one per run", arguments);
  verb->add_option("-o,--output", arguments.output, "File to write instead of standard output");
  verb->callback([&arguments] { dump_verb(arguments); });
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  using namespace slalom;
  Arguments arguments;
  return run_program("slalom-analyze",
                     "Tables and reports from result files, and metrics of any robot's logs", argc,
                     argv, [&arguments](CLI::App& app) {
                       define_interpreters(app);
                       define_import(app);
                       define_report(app, arguments);
                       define_registry(app);
                       define_show(app, arguments);
                       define_dump(app, arguments);
                       define_export(app);
                       define_trajectories(app);
                       define_figure(app);
                       define_metrics(app);
                       define_sim2real(app);
                     });
}
