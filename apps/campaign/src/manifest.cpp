#include "manifest.h"

#include <slalom/core/hash.h>
#include <slalom/core/read_file.h>
#include <slalom/core/version.h>
#include <slalom/library/library_method.h>

namespace slalom {
namespace {

std::string hash_of_scenarios(const std::vector<Scenario>& scenarios) {
  Hasher hasher;
  for (const Scenario& scenario : scenarios) hasher.add(scenario.hash());
  return hasher.hex();
}

}  // namespace

Manifest make_manifest(const CampaignConfig& config, const std::vector<Scenario>& scenarios) {
  Manifest manifest = {
      {"campaign", config.options.name},
      {"campaign.ini", config.ini.canonical_text()},
      {"seed", std::to_string(config.options.seed)},
      {"scenarios.hash", hash_of_scenarios(scenarios)},
      {"version.slalom", version()},
      {"version.mrpt", mrpt_version()},
      {"version.ompl", ompl_version()},
      {"version.compiler", compiler_version()},
  };
  for (const NamedMethod& method : config.methods) {
    const std::string section = "method." + method.name;
    const auto library = config.ini.get(section, "plugin");
    if (!library) continue;
    manifest[section + ".plugin_hash"] =
        Hasher()
            .add(read_file(resolve_plugin_path(config.ini, section, *library), "a library"))
            .hex();
  }
  return manifest;
}

}  // namespace slalom
