// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/campaign_program.h>
#include <slalom/app/recorded_campaign.h>
#include <slalom/core/error.h>
#include <slalom/io/scenario_yaml.h>

namespace slalom {

IniFile campaign_of(const RecordedRun& run, const std::string& path, const std::string& config,
                    const std::vector<std::string>& overrides) {
  if (!config.empty()) {
    CampaignArguments arguments;
    arguments.config = config;
    arguments.overrides = overrides;
    return load_campaign_ini(arguments);
  }
  IniFile ini = IniFile::from_text(run.manifest.campaign_ini, path + ": campaign.ini");
  for (const std::string& assignment : overrides) ini.override_key(assignment);
  return ini;
}

Scenario scenario_of(const RecordedRun& run, const std::string& path) {
  Scenario scenario = scenario_from_yaml(run.manifest.scenario_yaml, path + ": scenario.yaml");
  if (scenario.hash() != run.manifest.scenario_hash)
    throw file_error(path, "the scenario does not match its hash",
                     "a scenario with the hash " + run.manifest.scenario_hash);
  return scenario;
}

RunRecord record_of(const RecordedRun& run) {
  RunRecord record;
  record.scenario_hash = run.manifest.scenario_hash;
  record.scenario_name = run.manifest.scenario_name;
  record.method = run.manifest.method;
  record.repetition = run.manifest.repetition;
  record.seed = run.manifest.seed;
  record.outcome = to_string(run.outcome);
  record.outcome_detail = run.detail;
  return record;
}

}  // namespace slalom
