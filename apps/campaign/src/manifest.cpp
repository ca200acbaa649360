// SPDX-License-Identifier: BSD-3-Clause
#include "manifest.h"

#include <slalom/app/external_options.h>
#include <slalom/core/hash.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/methods/registry.h>
#include <slalom/results/privileged.h>

#include <algorithm>

namespace slalom {
namespace {

template <typename Text>
std::string hash_of(const std::vector<Scenario>& scenarios, Text text) {
  Hasher hasher;
  for (const Scenario& scenario : scenarios) hasher.add(text(scenario));
  return hasher.hex();
}

std::string method_names(const CampaignConfig& config) {
  std::vector<std::string> names;
  for (const NamedMethod& method : config.methods) names.push_back(method.name);
  std::sort(names.begin(), names.end());
  return join(names, ", ");
}

}  // namespace

std::string effective_ini(const IniFile& ini, const CampaignConfig& config) {
  IniFile effective = campaign_ini(config.options, "");
  effective.set("campaign", "methods", method_names(config));
  effective.remove("limits", "method_errors");
  effective.remove("record", "rawlog");
  effective.remove("record", "bag");
  effective.remove("record", "repeated_runs");
  write_options(effective, "reference", config.reference, "");
  for (const std::string& section : method_sections(ini, config.methods))
    for (const std::string& key : ini.keys(section))
      if (!is_location(ini, section, key))
        effective.set(section, key, ini.get(section, key).value_or(""));
  return effective.canonical_text();
}

Manifest hash_method_files(const CampaignConfig& config) {
  Manifest hashes;
  for (const auto* files : {&config.method_files, &config.dependencies})
    for (const auto& [key, path] : *files)
      hashes[key + "_hash"] = Hasher().add(read_file(path, "a file of a method")).hex();
  return hashes;
}

Manifest make_manifest(const CampaignConfig& config, const std::vector<Scenario>& scenarios,
                       const std::optional<StoppingRule>& rule) {
  Manifest manifest = {
      {"campaign", config.options.name},
      {"campaign.ini", config.ini_text},
      {kEffectiveKey, config.effective_ini},
      {"seed", std::to_string(config.options.seed)},
      {"scenarios.count", std::to_string(scenarios.size())},
      {"scenarios.hash", hash_of(scenarios, [](const Scenario& s) { return s.hash(); })},
      {"scenarios.names", hash_of(scenarios, [](const Scenario& s) { return s.name(); })},
      {"version.slalom", version()},
      {"version.mrpt", mrpt_version()},
      {"version.ompl", ompl_version()},
      {"version.compiler", compiler_version()},
      {"environment.processor", processor_name()},
  };
  manifest.merge(hash_method_files(config));
  store_privileged(config.privileged, manifest);
  if (!config.sample.empty()) manifest["quick"] = config.sample;
  if (rule) {
    manifest["until"] = rule->text;
    manifest["until.max_runs"] = std::to_string(rule->max_runs);
    manifest["until.confidence"] = format_number(config.analysis.confidence);
  }
  manifest[kIdentityKey] = campaign_identity(manifest);
  return manifest;
}

}  // namespace slalom
