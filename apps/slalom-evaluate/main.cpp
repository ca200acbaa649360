// SPDX-License-Identifier: BSD-3-Clause
#include "quick.h"

#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/table_text.h>
#include <slalom/app/bundled_methods.h>
#include <slalom/app/campaign_arguments.h>
#include <slalom/app/campaign_program.h>
#include <slalom/app/interrupt.h>
#include <slalom/app/output_folder.h>
#include <slalom/app/program.h>
#include <slalom/app/repeatability.h>
#include <slalom/core/available_cores.h>
#include <slalom/core/error.h>
#include <slalom/core/program_path.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/file_lock.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/report/report.h>
#include <slalom/results/privileged.h>
#include <slalom/results/untimely_commands.h>

#include <filesystem>
#include <iostream>

namespace slalom {
namespace {

struct Arguments {
  CampaignArguments campaign;
  std::string until;         ///< a StoppingRule
  std::size_t max_runs = 0;  ///< of that rule
  std::optional<int> quick;  ///< how many scenarios to sample
  std::string output;
  std::string bundle;  ///< a file to write, or ""
  bool with_sources = false;
};

/// Keeps the list of a campaign that is `continued`, to which descriptors or tags may have been
/// added; adds the scenarios of one that is extended.
void write_scenarios(const std::vector<Scenario>& scenarios, const std::string& ini_text,
                     bool continued, const std::string& path) {
  const auto fill = [&](ScenarioList& list) {
    list.add_all(scenarios);
    list.set_note("campaign.ini", ini_text);
  };
  if (!continued || !std::filesystem::exists(path)) return ScenarioList::write(path, fill);
  ScenarioList list = ScenarioList::open(path);
  if (list.size() != scenarios.size() || list.note("campaign.ini") != ini_text)
    list.in_transaction([&] { fill(list); });
}

/// Stores the descriptors of the results in the list, for programs that show it.
void store_descriptors(const CampaignOptions& options, const std::string& results,
                       const std::string& path) {
  const ResultFile file = ResultFile::open(results);
  ScenarioList list = ScenarioList::open(path);
  const auto store = [&](const std::string& hash) {
    const World world(list.read(hash), options.simulation.resolution);
    const DescriptorContext context{world, options.robot.shape(), options.sensor.max_range,
                                    search_once([] { return KnownPath{}; }),  // keys need no path
                                    options.exact_confinement};
    for (const auto& [id, value] : file.read_record(hash).descriptors) {
      const ValueKey key = descriptor(id).key(context);
      if (value.version == key.version && !list.find(hash, key))
        list.store_value(hash, {key, value.value});
    }
  };
  list.in_transaction([&] {
    for (const ScenarioList::Entry& entry : list.entries()) store(entry.hash);
  });
}

/// The run to look at if the processes of a method were silent or failed: the first such run in
/// which they printed an error, else the first one. "" if there is none.
std::string printed_errors(const std::string& results_path, const ResultTable& runs,
                           const std::string& method) {
  const ValueColumn* missing = find_metric(runs, "commands_missing");
  if (missing == nullptr) return "";
  const ResultFile file = ResultFile::open(results_path);
  std::string text;
  for (std::size_t row = 0; row < runs.size(); ++row) {
    if (runs.methods[runs.method[row]] != method) continue;
    const std::string& outcome = runs.outcomes[runs.outcome[row]];
    const double silent = missing->number(row);  // not a number of a method without processes
    if (!(silent > 0) && !(silent == 0 && is_method_failure(outcome))) continue;
    const auto run = file.read_run(runs.scenario_hashes[runs.scenario[row]],
                                   unmarked_name(runs, method), runs.repetition[row]);
    const std::string error = run ? last_error_printed(file.read_timing(*run).output) : "";
    if (!text.empty() && error.empty()) continue;
    text = method + ": what it printed: slalom-analyze show " + results_path + " --run " +
           run_id(runs, row);
    if (!error.empty()) return text + "; its last error: " + error;
  }
  return text;
}

/// Writes the tables to standard output and to files, and the report to a folder.
void write_tables_and_report(const Arguments& arguments, const std::string& results_path,
                             bool with_report) {
  ResultTable runs = read_results(results_path);
  warn_of_damage(results_path, runs.damaged);
  mark_privileged(runs);
  ReportOptions options = report_options(runs);
  options.campaign = {arguments.campaign.config};
  for (const std::string& setting : arguments.campaign.overrides)
    options.campaign.insert(options.campaign.end(), {"--set", setting});
  options.output = (std::filesystem::path(arguments.output) / "").parent_path().string();
  const std::string text =
      render_tables_text(runs, options.rows, options.columns, options.analysis.confidence);
  write_file_atomically(arguments.output + "/tables.txt", text);
  Interpretation tables;
  tables.cross_tables = build_cross_tables(runs, options.rows, options.columns, options.analysis);
  tables.footnote = privileged_footnote(runs);
  write_file_atomically(arguments.output + "/tables.csv", render_csv(tables));
  std::cout << text;
  for (const std::string& method : runs.methods)
    for (const auto& line_of : {untimely_commands, limited_commands})
      if (const std::string line = line_of(runs, method); !line.empty()) std::cerr << line << "\n";
  for (const std::string& method : runs.methods)
    if (const std::string line = printed_errors(results_path, runs, method); !line.empty())
      std::cerr << line << "\n";
  if (!with_report) return;
  const std::string report = arguments.output + "/report";
  write_report(results_path, std::move(runs), options, report);
  std::cout << "\nReport: " << report << "/index.html\n";
}

void evaluate(const Arguments& arguments) {
  const IniFile ini = load_campaign_ini(arguments.campaign);
  for (const char* name : {"/campaign.scenarios", "/runs.results", "/tables.txt", "/tables.csv",
                           "/until.txt", "/quick.txt"})
    refuse_output_over_inputs(arguments.output + name, ini);
  if (arguments.quick) check_quick_size(*arguments.quick);
  CampaignConfig config = read_campaign(ini);
  const auto read_rule = [&](const CampaignOptions& options) {
    return parse_stopping_rule(arguments.until, arguments.max_runs, options, config.methods);
  };
  std::optional<StoppingRule> rule;
  if (!arguments.until.empty()) {
    CampaignOptions possible = config.options;
    // Quantities as if the scenarios, which are not known yet, had movers, people and headings of
    // their goals.
    possible.add_mover_quantities();
    possible.add_people_metrics();
    possible.add_goal_heading_metrics();
    rule = read_rule(possible);
  }
  if (!arguments.bundle.empty()) refuse_output_over_inputs(arguments.bundle, ini);
  make_output_folder(arguments.output);
  const std::string results = arguments.output + "/runs.results";
  const InterruptGuard guard;  // from before the lock, which must not remain
  const FileLock lock(results, arguments.campaign.take_over, print_notice);
  std::vector<Scenario> scenarios = campaign_scenarios(config, arguments.campaign);
  if (rule) rule = read_rule(config.options);
  QuickSample quick;
  if (arguments.quick) {
    quick = choose_quick_sample(scenarios, *arguments.quick, config,
                                worker_count(arguments.campaign.jobs),
                                *make_interruptible_progress(arguments.campaign.quiet));
    config.sample = quick.text();
    scenarios = sampled_scenarios(quick, std::move(scenarios));
  }
  ResultFile file = open_campaign_results(config, arguments.campaign, scenarios, results, rule);
  write_scenarios(scenarios, config.ini_text,
                  arguments.campaign.existing != ExistingResults::Overwrite,
                  arguments.output + "/campaign.scenarios");
  const CampaignReport report =
      run_campaign_program(config, arguments.campaign, std::move(scenarios), std::move(file), rule);
  if (rule) {
    write_file_atomically(arguments.output + "/until.txt", report.until);
    std::cout << report.until << "\n";
  }
  if (!report.complete || InterruptGuard::raised())
    throw Interrupted("finished runs are kept in " + results + "; the same command continues");
  measure_repeatability(config, arguments.campaign, results);
  store_descriptors(config.options, results, arguments.output + "/campaign.scenarios");
  write_tables_and_report(arguments, results, config.analysis.report);
  if (arguments.quick) {
    const std::string answer = quick_answer(quick, results, config.analysis.confidence);
    write_file_atomically(arguments.output + "/quick.txt", answer);
    std::cout << "\n" << answer;
  }
  if (!arguments.bundle.empty())
    std::cout << write_campaign_bundle(results, arguments.bundle, config, arguments.with_sources)
              << "\n";
  print_method_failures(report, results);
  require_valid_runs(report, results);
}

void define(CLI::App& app) {
  static Arguments arguments;
  add_argument(app, {"campaign", "-c,--config", "The campaign's .ini"}, arguments.campaign.config);
  app.add_option("-o,--output", arguments.output,
                 "Folder for campaign.scenarios, runs.results, tables and report/ (required, but "
                 "for --demo: slalom-demo)");
  arguments.campaign.jobs = 0;
  add_campaign_options(app, arguments.campaign);
  CLI::Option* until = app.add_option("--until", arguments.until,
                                      "Run until a precision is reached, \"interval(success) < "
                                      "0.1 in density:10\", or a comparison is decided, "
                                      "\"compare(success, mine, nd) decided\", \"compare(success, "
                                      "mine, nd) no worse than 0.02\"");
  app.add_option("--max-runs", arguments.max_runs,
                 "With --until: no further batch after this number of runs")
      ->needs(until);
  app.add_option(
         "--quick", arguments.quick,
         "Run in a stratified sample of this number of the scenarios only, and estimate the "
         "success over all of them: for slow methods")
      ->excludes(until);
  CLI::Option* bundle =
      app.add_option("--bundle", arguments.bundle,
                     "Also write a bundle (.slalom), one small file with which others can verify "
                     "the results: slalom-simulate verify");
  app.add_flag("--with-sources", arguments.with_sources,
               "With --bundle: with the libraries, modules and models that the methods consist of")
      ->needs(bundle);
  // Defined after --set, whose values its own precede.
  app.add_flag_callback(
      "--demo",
      [] {
        if (!arguments.campaign.config.empty())
          throw CLI::ValidationError(
              "--demo", "'" + arguments.campaign.config + "' is another campaign; expected one");
        arguments.campaign.config = shipped_file("configs/demo.ini");
        if (arguments.output.empty()) arguments.output = "slalom-demo";
        const std::string maps = shipped_file("datasets/");
        if (std::filesystem::is_directory(maps))  // installed, maybe without MRPT
          arguments.campaign.overrides.insert(arguments.campaign.overrides.begin(),
                                              "scenarios.maps=" + maps +
                                                  "malaga-cs-fac-building.simplemap.gz, " + maps +
                                                  "localization_demo.simplemap.gz");
      },
      "Evaluate four methods in two buildings and 60 random scenarios, a campaign that comes with "
      "the program");
  app.add_flag_callback(
      "--options",
      [] {
        std::cout << campaign_options_help();
        throw CLI::Success();
      },
      "Print all sections and keys of a campaign .ini and exit");
  app.callback([] {
    if (arguments.output.empty()) throw CLI::RequiredError("--output");
    evaluate(arguments);
  });
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  return slalom::run_program("slalom-evaluate",
                             "Runs a complete campaign: scenarios, runs, tables, report. The "
                             "same command continues one that was interrupted.",
                             argc, argv, slalom::define);
}
