#include "recorded_campaign.h"

#include <slalom/app/campaign_program.h>
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
    throw file_error(path, "its scenario is not the one that was driven",
                     "a scenario with the hash " + run.manifest.scenario_hash);
  return scenario;
}

}  // namespace slalom
