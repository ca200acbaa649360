// SPDX-License-Identifier: BSD-3-Clause
#include "arguments.h"

#include <slalom/app/campaign_names.h>
#include <slalom/app/checks.h>
#include <slalom/campaign/campaign.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

/// The names of the method and its witnesses.
std::vector<std::string> method_names(const IniFile& ini, const FalsifyArguments& arguments) {
  std::vector<std::string> names = {arguments.method};
  const std::vector<std::string> others =
      arguments.witnesses.empty() ? split_nonempty(ini.get("campaign", "methods").value_or(""), ',')
                                  : arguments.witnesses;
  for (const std::string& name : others) {
    if (!contains(names, name)) names.push_back(name);
    if (!arguments.witnesses.empty() && name == arguments.method)
      throw usage_error("--witness " + name, "is the method that is tested", "another method");
  }
  return names;
}

/// The campaign of the light surrogate alone: the one that repeats the failures does not run it.
CampaignConfig read_surrogate(IniFile ini, const FalsifyArguments& arguments,
                              const FalsificationSetup& setup) {
  const std::string option = "--surrogate " + arguments.surrogate;
  if (arguments.surrogate == arguments.method)
    throw usage_error(option, "is the method that is tested", "another method");
  if (arguments.fairness.witness != NeedsWitness::Never && setup.witnesses.size() == 1 &&
      setup.witnesses.front().name == arguments.surrogate)
    throw usage_error(option, "is the only witness, and fails in all these scenarios",
                      "another method, or --witness METHOD");
  ini.set("campaign", "methods", arguments.surrogate);
  CampaignConfig config = read_campaign(ini);
  check_campaign(config);
  return config;
}

}  // namespace

void add_falsify_options(CLI::App& app, FalsifyArguments& arguments) {
  app.add_option("-o,--output", arguments.output,
                 "Folder for the failures and the report of them (index.html)")
      ->required();
  complete_with(
      app.add_option(
             "--witness", arguments.witnesses,
             "A method that must reach the goal, which proves that the scenario can be solved; "
             "of several, any. Default: the other methods of the campaign, and among people, "
             "without a proof, the method itself if they do not notice it; none need to for what "
             "only the method can cause, as a collision where nothing moves")
          ->take_all()
          ->allow_extra_args(false),
      known_methods);
  FairnessOptions& fairness = arguments.fairness;
  app.add_option("--min-bottleneck", fairness.min_bottleneck,
                 "Certified width of the widest path, in robot widths; 0: any")
      ->check(not_negative())
      ->capture_default_str();
  app.add_option("--min-clearance", fairness.min_start_clearance,
                 "Free distance around the robot at the start, m; 0: any")
      ->check(not_negative())
      ->capture_default_str();
  app.add_option("--min-distance", fairness.min_distance,
                 "Straight-line distance from start to goal, m; 0: any")
      ->check(not_negative())
      ->capture_default_str();
  app.add_flag_callback(
      "--no-witness", [&fairness] { fairness.witness = NeedsWitness::Never; },
      "Accept failures where no witness reaches the goal");
  app.add_flag_callback(
      "--no-repeat", [&fairness] { fairness.repeatable = false; },
      "Accept failures that a new process does not repeat bit for bit");
  app.add_option("--max-runs", arguments.max_runs, "Runs to shrink one failure")
      ->check(above_zero())
      ->capture_default_str();
  app.add_option("--set", arguments.campaign.overrides,
                 "Override a key of the .ini: SECTION.KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  app.add_flag("--quiet", arguments.campaign.quiet, "No progress and no messages, except errors");
}

void excuse_unnamed_witnesses(FalsifyArguments& arguments) {
  NeedsWitness& witness = arguments.fairness.witness;
  if (arguments.witnesses.empty() && witness == NeedsWitness::Always)
    witness = NeedsWitness::NotForOwn;
}

FalsifyCampaign read_falsify_campaign(IniFile ini, const FalsifyArguments& arguments) {
  require_method(ini, "--method", arguments.method);
  for (const std::string& witness : arguments.witnesses) require_method(ini, "--witness", witness);
  if (!arguments.surrogate.empty()) require_method(ini, "--surrogate", arguments.surrogate);
  ini.set("campaign", "methods", join(method_names(ini, arguments), ", "));
  CampaignConfig config = read_campaign(ini);
  check_campaign(config);
  FalsificationSetup setup;
  setup.run = config.options;
  setup.limits = config.options.limits;
  setup.seed = config.options.seed;
  setup.walkers = config.sources.section.walkers;
  setup.people = config.sources.section.people;
  setup.unnoticed_witness = arguments.witnesses.empty();
  setup.method = config.methods.front();
  setup.witnesses.assign(config.methods.begin() + 1, config.methods.end());
  CampaignConfig surrogate;
  if (!arguments.surrogate.empty()) {
    surrogate = read_surrogate(ini, arguments, setup);
    setup.surrogate = surrogate.methods.front();
  }
  return {std::move(ini), std::move(config), std::move(setup), std::move(surrogate)};
}

}  // namespace slalom
