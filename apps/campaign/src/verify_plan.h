// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/campaign_program.h>
#include <slalom/core/progress.h>
#include <slalom/io/result_file.h>

#include <string>
#include <vector>

namespace slalom {

/// The runs of its campaign that a result file contains.
struct PlanComparison {
  std::size_t planned = 0, present = 0;  ///< runs, each counted once
  std::string shard;          ///< "3/16": the file contains no other part; "": the whole campaign
  std::string first_missing;  ///< HASH8/METHOD/REPETITION, or "a scenario"
  std::string foreign;        ///< a run that is not in the plan

  /// Whether the file contains all runs of its campaign, or of the shard that it is.
  bool is_whole() const { return first_missing.empty() && present == planned && foreign.empty(); }
  bool complete() const { return shard.empty() && is_whole(); }
  /// "lacks 3 of 2001 runs of its campaign, run 0123abcd/nd/0 first".
  std::string text() const;
};

/// Compares with the plan of the campaign: all methods and repetitions in all scenarios, of which
/// there are as many as the manifest says. With a stopping rule the number of scenarios is not
/// known before.
PlanComparison compare_plan(const ResultFile& file, const CampaignConfig& config);

/// Statements of the manifest that `config`, read from its .ini, does not make: an option, the
/// methods that know the map. Versions, files of methods and the processor are not compared.
/// A key that the manifest leaves out has its default, unless `ini` sets it.
std::vector<std::string> statement_differences(const ResultFile& file, const CampaignConfig& config,
                                               const IniFile& ini);

/// The scenarios of a result file.
struct ScenarioSet {
  std::string text;  ///< "667 scenarios, generated again, hash 0123..." or what they are instead
  std::vector<std::string> differences;
  std::vector<Scenario> made;  ///< again; empty if the campaign does not generate all of them
};

/// Makes the scenarios again if the campaign generates all of them, and compares. A list and maps
/// are not read: what counts is the hash of their scenarios, see content_hash(), and the name of
/// the test bed that has it.
ScenarioSet compare_scenarios(const ResultFile& file, const CampaignConfig& config, int jobs,
                              Progress& progress);

/// Applies the stopping rule of the manifest again to the runs of the file, with `pool` as what its
/// campaign generates. Returns what contradicts it; "" if it stops after these runs. Runs that the
/// file lacks until then are executed.
std::string compare_stop(const ResultFile& file, const Campaign& campaign,
                         const std::vector<Scenario>& pool, const Execution& execution);

}  // namespace slalom
