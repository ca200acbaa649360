#include "manifest.h"

#include <slalom/core/hash.h>
#include <slalom/core/version.h>
#include <slalom/io/result_file.h>
#include <slalom/library/library_method.h>
#include <slalom/ompl/ompl_planner.h>

namespace slalom {
namespace {

std::string hash_of_scenarios(const std::vector<Scenario>& scenarios) {
  Hasher hasher;
  for (const Scenario& scenario : scenarios) hasher.add(scenario.hash());
  return hasher.hex();
}

}  // namespace

Manifest make_manifest(const Campaign& campaign) {
  Manifest manifest = {
      {"campaign", campaign.options.name},
      {"campaign.ini", campaign.ini.canonical_text()},
      {"seed", std::to_string(campaign.options.seed)},
      {"scenarios.hash", hash_of_scenarios(campaign.scenarios)},
      {"version.slalom", version()},
      {"version.mrpt", mrpt_version()},
      {"version.ompl", ompl_version()},
      {"version.compiler", compiler_version()},
  };
  for (const std::string& name : campaign.options.methods) {
    const std::string section = "method." + name;
    const auto plugin = campaign.ini.get(section, "plugin");
    if (!plugin) continue;
    manifest[section + ".plugin_hash"] =
        Hasher().add(read_file(resolve_plugin_path(campaign.ini, section, *plugin))).hex();
  }
  return manifest;
}

}  // namespace slalom
