// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/program.h>
#include <slalom/app/verify_results.h>

#include <iostream>

namespace slalom {
namespace {

struct VerifyArguments {
  std::string results;
  CampaignArguments campaign;
  VerifySample sample;
};

void verify(const VerifyArguments& arguments) {
  const VerifyReport report = verify_results(arguments.results, arguments.campaign,
                                             arguments.sample, [](const auto& differences) {
                                               for (const std::string& line : differences)
                                                 std::cout << "environment: " << line << "\n";
                                             });
  for (const std::string& line : report.time_limits) std::cout << "environment: " << line << "\n";
  for (const std::string& line : report.not_repeatable) std::cout << line << "\n";
  for (const std::string& line : report.differences) std::cout << line << "\n";
  std::cout << verdict(report, arguments.results) << "\n";
}

}  // namespace

void define_verify(CLI::App& app) {
  static VerifyArguments arguments;
  CLI::App* verb =
      app.add_subcommand("verify", "Run a sample or one run again and compare it bit by bit");
  verb->add_option("results", arguments.results, "A result file (.results)")->required();
  CLI::Option* fraction =
      verb->add_option("--fraction", arguments.sample.fraction, "Part of the scenarios")
          ->check(CLI::Range(0.0, 1.0))
          ->capture_default_str();
  verb->add_option("--run", arguments.sample.run, "Only this run: SCENARIO/METHOD/REPETITION")
      ->excludes(fraction);
  verb->add_option("--seed", arguments.sample.seed, "Seed of the choice of scenarios")
      ->capture_default_str();
  verb->add_option("-c,--config", arguments.campaign.config,
                   "The campaign's .ini, if its files are elsewhere; default: that in the results");
  verb->add_flag("--trust", arguments.sample.trust,
                 "Execute the libraries, modules and commands that the results name");
  add_jobs_option(*verb, arguments.campaign.jobs, "Worker processes");
  verb->add_flag("--quiet", arguments.campaign.quiet, "No progress");
  verb->callback([] { verify(arguments); });
}

}  // namespace slalom
