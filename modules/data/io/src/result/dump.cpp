// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/io/result_file.h>

#include <nlohmann/json.hpp>

#include <ostream>

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

std::string dump_line(const std::string& campaign, const ScenarioRecord& scenario,
                      const RunRecord& run) {
  const Json json = {
      {"campaign", campaign},
      {"scenario", {{"hash", run.scenario_hash}, {"name", run.scenario_name}}},
      {"method", run.method},
      {"repetition", run.repetition},
      {"seed", run.seed},
      {"outcome", run.outcome},
      {"outcome_detail", run.outcome_detail},
      {"metrics", to_json(run.metrics)},
      {"descriptors", to_json(scenario.descriptors)},
      {"trajectory_hash", run.trajectory_hash},
  };
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void dump(const ResultFile& file, std::ostream& out, const DamageHandler& report) {
  const std::string campaign = file.read_manifest()["campaign"];
  ScenarioRecord scenario;  // of the last run: runs are ordered by scenario
  file.for_each_run(
      [&](const RunRecord& run) {
        try {
          if (!file.has_scenario(run.scenario_hash))
            throw file_error(file.path() + ": run " + run_id(run), "its scenario is missing");
          if (run.scenario_hash != scenario.hash) scenario = file.read_record(run.scenario_hash);
          out << dump_line(campaign, scenario, run) << '\n';
        } catch (const Error&) {
          if (!report) throw;
          report("scenario of run " + run_id(run));
        }
      },
      report);
}

}  // namespace slalom
