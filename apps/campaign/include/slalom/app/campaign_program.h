// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/analysis_section.h>
#include <slalom/campaign/open_results.h>
#include <slalom/campaign/scenario_sources.h>
#include <slalom/campaign/sequential_campaign.h>
#include <slalom/campaign/shards.h>
#include <slalom/core/ini_file.h>
#include <slalom/ompl/ompl_planner.h>
#include <slalom/results/method_failures.h>
#include <slalom/results/privileged.h>
#include <slalom/scenario/scenario.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Command-line arguments of programs that run campaigns.
struct CampaignArguments {
  std::string config;                  ///< the campaign's .ini
  std::vector<std::string> overrides;  ///< SECTION.KEY=VALUE
  std::optional<std::uint64_t> seed;   ///< instead of [campaign] seed
  int jobs = 1;  ///< worker processes, and threads for scenario generation; 0: one per core
  bool quiet = false;
  ExistingResults existing = ExistingResults::Continue;
  bool take_over = false;  ///< see FileLock
  Shard shard;             ///< the part of the campaign to run
};

/// Loads the campaign's .ini with the overrides of the command line. Throws Error (Usage) for
/// unknown sections.
IniFile load_campaign_ini(const CampaignArguments& arguments);

/// The same for an .ini that was loaded from elsewhere.
IniFile with_overrides(IniFile ini, const CampaignArguments& arguments);

/// Throws Error (Usage) at `option` for a name that is no method of the .ini.
void require_method(const IniFile& ini, const std::string& option, const std::string& name);

/// A campaign's .ini as values, read once per program.
struct CampaignConfig {
  std::string ini_name;       ///< path of the .ini
  std::string ini_text;       ///< IniFile::canonical_text(), for manifests
  std::string effective_ini;  ///< the values that may change a result
  ScenarioSources sources;
  CampaignOptions options;
  OmplOptions reference;
  AnalysisSection analysis;
  std::vector<NamedMethod> methods;
  /// Files whose contents may change results: paths by "method.NAME.plugin", "method.NAME.config".
  std::map<std::string, std::string> method_files;
  /// Dependencies of those: paths by "method.NAME.module/helper.py"; known after check_campaign().
  std::map<std::string, std::string> dependencies;
  PrivilegedMethods privileged;  ///< see check_campaign()
  std::string sample;       ///< of which scenarios the campaign has a sample, as text; "" for all
  bool one_worker = false;  ///< a method is a running process, which serves one worker only
};

/// Throws Error (Usage) for invalid values, and for ids in [analysis] that the campaign does not
/// compute.
CampaignConfig read_campaign(const IniFile& ini);

/// The number of worker processes that the arguments say; for 0 one per core, or one in total if a
/// method can serve only one.
int campaign_workers(const CampaignConfig& config, const CampaignArguments& arguments);

/// All sections and keys of a campaign .ini with default, unit, range and description.
std::string campaign_options_help();

/// The result of a campaign.
struct CampaignReport {
  bool complete = false;  ///< false if interrupted
  std::string problem;    ///< one line about failures of the infrastructure; "" if none
  MethodFailures failures;
  std::string until;  ///< with a stopping rule: its cells, and the reason for stopping
};

/// Prints on standard error which methods ended runs by errors of their own, and how.
void print_method_failures(const CampaignReport& report, const std::string& results_path);

/// Throws Error (Job) for problems of the report: failures of the infrastructure, and methods that
/// ended every run by an error of their own.
void require_valid_runs(const CampaignReport& report, const std::string& results_path);

/// Builds each method once in a process of its own and finds what it depends on: sets
/// config.privileged and config.dependencies. Throws Error (Usage) if one cannot be built.
void check_campaign(CampaignConfig& config);

/// The hashes of config.method_files and config.dependencies by "method.NAME.plugin_hash". Throws
/// Error (File) for one that cannot be read.
Manifest hash_method_files(const CampaignConfig& config);

/// The scenarios specified by the .ini; the same for any number of jobs. Calls check_campaign()
/// first.
std::vector<Scenario> campaign_scenarios(CampaignConfig& config,
                                         const CampaignArguments& arguments);

/// The result file of the campaign over `scenarios`: an existing one is continued or replaced, as
/// the arguments say. The caller holds its FileLock. Throws as open_results().
ResultFile open_campaign_results(const CampaignConfig& config, const CampaignArguments& arguments,
                                 const std::vector<Scenario>& scenarios,
                                 const std::string& results_path,
                                 const std::optional<StoppingRule>& rule = std::nullopt);

/// Runs the campaign over `scenarios`, or as many of them as the stopping rule requires, into that
/// file, except what it already holds. SIGINT and SIGTERM interrupt it; finished runs are kept.
/// Throws Error.
CampaignReport run_campaign_program(const CampaignConfig& config,
                                    const CampaignArguments& arguments,
                                    std::vector<Scenario> scenarios, ResultFile results,
                                    const std::optional<StoppingRule>& rule = std::nullopt);

}  // namespace slalom
