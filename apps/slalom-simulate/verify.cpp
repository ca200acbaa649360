// SPDX-License-Identifier: BSD-3-Clause
#include "badge.h"
#include "verbs.h"

#include <slalom/app/bundled_methods.h>
#include <slalom/app/checks.h>
#include <slalom/app/external_options.h>
#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>
#include <slalom/app/verify_results.h>
#include <slalom/core/scratch_folder.h>
#include <slalom/io/bundle.h>

#include <iostream>
#include <random>

namespace slalom {
namespace {

struct VerifyArguments {
  std::string results;
  CampaignArguments campaign;
  VerifySample sample;
  bool badge = false, only_new = false;
  std::string badge_folder;
};

/// The methods in a bundle are those that are run, unless an .ini is given. What they execute is
/// judged as it is then: a bundle may contain a file for an option that names a shipped library.
void use_bundled_methods(VerifyArguments& arguments, const ScratchFolder& folder) {
  const std::string& bundle = arguments.results;
  if (!arguments.campaign.config.empty() || read_bundled_files(bundle).empty()) return;
  arguments.campaign.config = unpack_methods(bundle, folder.path());
  if (!arguments.sample.trust)
    require_no_foreign_code(
        load_campaign_ini(arguments.campaign), {}, bundle,
        "--trust if you trust it; slalom-simulate unpack shows what it contains");
}

/// The author of a file must not know which runs are executed again: they could be right, and no
/// others.
void choose_sample(VerifySample& sample) {
  if (sample.seed || sample.fraction >= 1 || !sample.run.empty()) return;
  sample.seed = std::random_device()();
  std::cout << "sample: --seed " << *sample.seed << "\n";
}

void print_environment(const std::vector<std::string>& differences) {
  for (const std::string& line : differences) std::cout << "environment: " << line << "\n";
}

void verify(VerifyArguments& arguments) try {
  const InterruptGuard guard;  // so that the folder is removed
  if (arguments.only_new && has_badge(arguments.results, arguments.badge_folder)) {
    std::cout << arguments.results << " was verified\n";
    return;
  }
  const ScratchFolder folder;
  use_bundled_methods(arguments, folder);
  choose_sample(arguments.sample);
  const VerifyReport report =
      verify_results(arguments.results, arguments.campaign, arguments.sample, print_environment);
  if (!report.scenario_set.empty()) std::cout << "scenarios: " << report.scenario_set << "\n";
  for (const std::string& line : report.time_limits) std::cout << "environment: " << line << "\n";
  for (const std::string& line : report.not_repeatable) std::cout << line << "\n";
  for (const std::string& line : report.unchecked) std::cout << line << "\n";
  for (const std::string& line : report.differences) std::cout << line << "\n";
  if ((arguments.badge || !arguments.badge_folder.empty()) && report.complete)
    write_badge(arguments.results, arguments.badge_folder, arguments.sample, report);
  if (report.scenarios < report.total_scenarios)
    std::cout << "sample: finds changed runs with a probability of 95 % if they are in "
              << detectable_changes(report.scenarios, report.total_scenarios) << " of "
              << report.total_scenarios << " scenarios or more\n";
  std::cout << verdict(report, arguments.results) << "\n";
} catch (const Interrupted&) {
  throw Interrupted("nothing was changed");
}

}  // namespace

void define_verify(CLI::App& app) {
  static VerifyArguments arguments;
  CLI::App* verb =
      app.add_subcommand("verify", "Run a sample or one run again and compare it bit by bit");
  verb->add_option("results", arguments.results, "A result file (.results) or bundle (.slalom)")
      ->required();
  CLI::Option* fraction =
      verb->add_option("--fraction", arguments.sample.fraction, "Part of the scenarios")
          ->check(in_range(0.0, 1.0))
          ->capture_default_str();
  CLI::Option* run =
      verb->add_option("--run", arguments.sample.run, "Only this run: SCENARIO/METHOD/REPETITION")
          ->excludes(fraction);
  verb->add_option("--seed", arguments.sample.seed,
                   "Seed of the choice of scenarios; default: a random one, which is printed");
  verb->add_option("-c,--config", arguments.campaign.config,
                   "The campaign's .ini, if its files are elsewhere; default: that in the results");
  verb->add_flag("--trust", arguments.sample.trust,
                 "Execute the libraries, modules and commands that the results name");
  verb->add_flag("!--no-scenarios", arguments.sample.scenarios,
                 "Do not generate the scenarios again to compare them");
  verb->add_flag("--badge", arguments.badge,
                 "Write what was found to RESULTS.verified.json and a badge, RESULTS.verified.svg")
      ->excludes(run);
  CLI::Option* folder =
      verb->add_option(
              "--badge-folder", arguments.badge_folder,
              "Write that to a folder, by the hash of the file, for slalom-analyze registry")
          ->excludes(run);
  verb->add_flag("--new", arguments.only_new, "Do nothing if that folder has it already")
      ->needs(folder);
  add_jobs_option(*verb, arguments.campaign.jobs, "Worker processes");
  verb->add_flag("--quiet", arguments.campaign.quiet, "No progress");
  verb->callback([] { verify(arguments); });
}

}  // namespace slalom
