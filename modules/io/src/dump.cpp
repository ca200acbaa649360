#include <slalom/io/result_file.h>

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

using Json = nlohmann::json;  // objects are ordered by key

Json to_json(const std::map<std::string, VersionedValue>& values) {
  Json json = Json::object();
  for (const auto& [id, versioned] : values) {
    Json& entry = json[id];
    entry["version"] = versioned.version;
    if (versioned.value.is_na()) {
      entry["na"] = versioned.value.reason();
    } else {
      entry["value"] = versioned.value.number();
    }
    if (versioned.value.standard_error())
      entry["standard_error"] = *versioned.value.standard_error();
  }
  return json;
}

}  // namespace

std::string dump_line(const ResultTable& table, const RunRecord& run) {
  const auto campaign = table.manifest.find("campaign");
  const auto scenario = table.scenarios.find(run.scenario_hash);
  const Json json = {
      {"campaign", campaign == table.manifest.end() ? "" : campaign->second},
      {"scenario", {{"hash", run.scenario_hash}, {"name", run.scenario_name}}},
      {"method", run.method},
      {"repetition", run.repetition},
      {"seed", run.seed},
      {"outcome", run.outcome},
      {"outcome_detail", run.outcome_detail},
      {"metrics", to_json(run.metrics)},
      {"descriptors",
       scenario == table.scenarios.end() ? Json::object() : to_json(scenario->second.descriptors)},
      {"trajectory_hash", run.trajectory_hash},
  };
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace slalom
