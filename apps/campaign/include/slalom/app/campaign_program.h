#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/results/run_record.h>
#include <slalom/scenario/scenario.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// What a user may say on the command line of a program that runs campaigns.
struct CampaignArguments {
  std::string config;                  ///< the campaign's .ini
  std::vector<std::string> overrides;  ///< SECTION.KEY=VALUE
  std::optional<std::uint64_t> seed;   ///< instead of [campaign] seed
  int jobs = 1;                        ///< worker processes, and threads that generate scenarios
  bool quiet = false;
};

/// The campaign's .ini with the overrides of the command line; unknown sections are refused.
IniFile load_campaign_ini(const CampaignArguments& arguments);

/// Every section and key of a campaign .ini with default, unit, range and meaning.
std::string campaign_options_help();

/// How a finished campaign went.
struct CampaignReport {
  bool complete = false;  ///< false when interrupted
  std::string problem;    ///< one line when something of the job itself failed; "" otherwise
};

/// The scenarios that the .ini names; the same for any number of jobs.
std::vector<Scenario> campaign_scenarios(const IniFile& ini, const CampaignArguments& arguments);

/// Runs the campaign of `ini` over `scenarios` into a result file at `results_path`, with every
/// adapter that Slalom has. SIGINT and SIGTERM end it early with what is there kept. Throws Error.
CampaignReport run_campaign_program(const IniFile& ini, const CampaignArguments& arguments,
                                    std::vector<Scenario> scenarios,
                                    const std::string& results_path);

}  // namespace slalom
