// SPDX-License-Identifier: BSD-3-Clause
#include "failure_campaign.h"
#include "verbs.h"

#include <slalom/app/campaign_names.h>
#include <slalom/app/external_options.h>
#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>
#include <slalom/app/recorded_campaign.h>
#include <slalom/core/error.h>
#include <slalom/core/progress.h>
#include <slalom/core/text.h>
#include <slalom/io/find_run.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/results/recorded_ini.h>

#include <filesystem>
#include <iostream>
#include <system_error>

namespace slalom {
namespace {

struct ShrinkArguments {
  FalsifyArguments common;
  std::string input, run;
  bool trust = false;
};

/// The failing scenario to shrink.
struct ShrinkInput {
  IniFile ini;
  Scenario scenario;
  std::string origin;
  int repetition = 0;
  std::optional<RunRecord> recorded;
};

IniFile ini_of(const ResultFile& file, const FalsifyArguments& arguments) {
  if (!arguments.campaign.config.empty()) return load_campaign_ini(arguments.campaign);
  IniFile ini = recorded_ini(file.read_manifest(), file.path());
  for (const std::string& assignment : arguments.campaign.overrides) ini.override_key(assignment);
  return ini;
}

/// Takes the method of the run, unless another one is named, which is an error.
void set_method(std::string& method, const RunRecord& run) {
  if (!method.empty() && method != run.method)
    throw usage_error("--method " + method, "is not the method of run " + run_id(run), run.method);
  method = run.method;
}

ShrinkInput input_of_run(ShrinkArguments& arguments) {
  const ResultFile file = ResultFile::open(arguments.input);
  const RunRecord run = find_run(file, arguments.run);
  set_method(arguments.common.method, run);
  return {ini_of(file, arguments.common), file.read_scenario(run.scenario_hash),
          "run " + run_id(run) + " of " + arguments.input, run.repetition, run};
}

ShrinkInput input_of_rawlog(ShrinkArguments& arguments) {
  const RecordedRun recorded = read_run(arguments.input);
  const RunRecord run = record_of(recorded);
  set_method(arguments.common.method, run);
  const CampaignArguments& campaign = arguments.common.campaign;
  return {campaign_of(recorded, arguments.input, campaign.config, campaign.overrides),
          scenario_of(recorded, arguments.input), "run " + run_id(run) + " of " + arguments.input,
          run.repetition, run};
}

ShrinkInput read_input(ShrinkArguments& arguments) {
  if (ends_with(arguments.input, ".rawlog")) {
    if (arguments.run.empty()) return input_of_rawlog(arguments);
    throw usage_error("--run " + arguments.run, "a .rawlog has one run only", "no --run");
  }
  if (!arguments.run.empty()) return input_of_run(arguments);
  if (ends_with(arguments.input, ".results"))
    throw usage_error(arguments.input, "no run is named", "--run ID, as in reports");
  if (arguments.common.campaign.config.empty())
    throw usage_error(arguments.input, "no campaign is named", "-c campaign.ini");
  if (arguments.common.method.empty())
    throw usage_error(arguments.input, "no method is named", "--method NAME");
  return {load_campaign_ini(arguments.common.campaign), load_scenario_yaml(arguments.input),
          "scenario " + arguments.input, 0, std::nullopt};
}

void shrink_verb(ShrinkArguments& arguments) {
  const ShrinkInput input = read_input(arguments);
  FalsifyArguments& common = arguments.common;
  excuse_unnamed_witnesses(common);
  if (common.campaign.config.empty() && !arguments.trust)
    require_no_foreign_code(input.ini, {}, arguments.input);
  refuse_output_over_inputs(common.output, input.ini);
  std::error_code ignored;
  if (std::filesystem::equivalent(arguments.input, common.output + "/" + kExaminedResults, ignored))
    throw usage_error("-o " + common.output, "would replace " + arguments.input, "another folder");
  FalsifyCampaign campaign = read_falsify_campaign(input.ini, common);
  campaign.setup.repetition = input.repetition;
  const InterruptGuard guard;
  const auto progress = make_terminal_progress(common.campaign.quiet);
  progress->start("Shrinking", common.max_runs);
  ShrinkOptions options{common.fairness, common.max_runs, InterruptGuard::raised,
                        [&progress](std::size_t runs) { progress->advance(runs); }};
  auto small = shrink(campaign.setup, input.scenario, options);
  progress->finish();
  if (!small) throw Interrupted("nothing was written");
  std::vector<Failure> failures = {{input.origin, input.scenario, std::move(*small)}};
  name_failures(failures, common.method);
  failures[0].neighbors =
      one_removal_variants(failures[0].small.scenario, campaign.setup.run.simulation.resolution);
  write_output(failures, campaign, common.output);
  const std::vector<ReportedCluster> clusters = report_clusters(failures, campaign, common);
  std::cout << failure_text(failures[0], campaign.setup) << "  show it    "
            << show_command(failures[0], campaign.setup, common.output) << "\n"
            << clusters_text(clusters, common.output);
  const Trial& trial = failures[0].small.trial;
  if (input.recorded && input.recorded->outcome != to_string(trial.outcome))
    throw job_error(input.origin,
                    "ended as " + input.recorded->outcome + ", now as " + to_string(trial.outcome),
                    "the method with which it was recorded");
  if (!failures[0].small.fairness.fair())
    throw job_error(failures[0].small.scenario.name(),
                    "not fair: " + join(failures[0].small.fairness.violations, "; "));
}

}  // namespace

void define_shrink(CLI::App& app) {
  static ShrinkArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "shrink", "Shrink a failure to the smallest scenario that reproduces the failure");
  verb->add_option("input", arguments.input,
                   "A result file (.results), a recorded run (.rawlog) or a .scenario.yaml")
      ->required();
  verb->add_option("--run", arguments.run,
                   "The run of the result file: SCENARIO/METHOD/REPETITION");
  verb->add_option("-c,--config", arguments.common.campaign.config,
                   "The campaign's .ini; default: that in the result file or the recorded run");
  verb->add_flag("--trust", arguments.trust,
                 "Execute the libraries, modules and commands that the input names");
  complete_with(
      verb->add_option("--method", arguments.common.method, "The method; default: that of the run"),
      known_methods);
  add_falsify_options(*verb, arguments.common);
  verb->callback([] { shrink_verb(arguments); });
}

}  // namespace slalom
