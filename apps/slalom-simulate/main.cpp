// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/campaign_arguments.h>
#include <slalom/app/campaign_program.h>
#include <slalom/app/external_options.h>
#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/file_lock.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/results/recorded_ini.h>

#include <iostream>

namespace slalom {
namespace {

struct RunArguments {
  CampaignArguments campaign;
  std::string scenarios;
  std::string output;
  bool trust = false;
};

/// The campaign's .ini: a file of its own, or that in a result file.
IniFile read_ini(const RunArguments& arguments) {
  const std::string& path = arguments.campaign.config;
  if (!ends_with(path, ".results")) return load_campaign_ini(arguments.campaign);
  const IniFile recorded = recorded_ini(ResultFile::open(path).read_manifest(), path);
  if (recorded.sections().empty())
    throw file_error(path, "contains no campaign", "results of Slalom, or the .ini of a campaign");
  IniFile ini = with_overrides(recorded, arguments.campaign);
  if (!arguments.trust)
    require_no_foreign_code(ini, {}, path, "an .ini of your own, or --trust if you trust the file");
  return ini;
}

/// Runs the methods of a campaign over a scenario list into a result file.
void run(const RunArguments& arguments) {
  IniFile ini = read_ini(arguments);
  if (!arguments.scenarios.empty()) {
    for (const std::string& key : ini.keys("scenarios")) ini.remove("scenarios", key);
    ini.set("scenarios", "list", arguments.scenarios);
  }
  refuse_output_over_inputs(arguments.output, ini);
  CampaignConfig config = read_campaign(ini);
  const InterruptGuard guard;  // from before the lock, which must not remain
  const FileLock lock(arguments.output, arguments.campaign.take_over, print_notice);
  std::vector<Scenario> scenarios = campaign_scenarios(config, arguments.campaign);
  ResultFile results =
      open_campaign_results(config, arguments.campaign, scenarios, arguments.output);
  const CampaignReport report =
      run_campaign_program(config, arguments.campaign, std::move(scenarios), std::move(results));
  if (!report.complete)
    throw Interrupted("finished runs are kept in " + arguments.output +
                      "; the same command continues");
  print_method_failures(report, arguments.output);
  require_valid_runs(report, arguments.output);
  if (!arguments.campaign.quiet) std::cerr << "Results: " << arguments.output << "\n";
}

void define(CLI::App& app) {
  static RunArguments arguments;
  CLI::App* verb = app.add_subcommand("run",
                                      "Run methods over scenarios into a result file; the same "
                                      "command continues one that was interrupted");
  add_argument(
      *verb, {"campaign", "-c,--config", "The campaign's .ini, or a result file that contains it"},
      arguments.campaign.config);
  verb->add_option("--scenarios", arguments.scenarios,
                   "A scenario list (.scenarios) instead of [scenarios]");
  verb->add_option("-o,--output", arguments.output, "The result file (.results) to write")
      ->required();
  verb->add_flag("--trust", arguments.trust,
                 "Execute the libraries, modules and commands that a result file names");
  verb->add_option_function<std::string>(
      "--shard",
      [](const std::string& text) { arguments.campaign.shard = parse_shard(text, "--shard"); },
      "Run only part I of N parts, I/N with I from 1 to N, such as 3/16; see slalom-simulate "
      "merge");
  add_campaign_options(*verb, arguments.campaign);
  verb->callback([] { run(arguments); });
  define_bundle(app);
  define_merge(app);
  define_status(app);
  define_parameters(app);
  define_slurm(app);
  define_verify(app);
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  return slalom::run_program("slalom-simulate",
                             "Runs avoidance methods over scenarios in simulation.", argc, argv,
                             slalom::define);
}
