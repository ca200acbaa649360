// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
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

std::string line_difference(const std::string& before, const std::string& now) {
  if (before == now) return "";
  const nlohmann::json old = nlohmann::json::parse(before), found = nlohmann::json::parse(now);
  const nlohmann::json changes = nlohmann::json::diff(old, found);
  const nlohmann::json::json_pointer at(changes.at(0).at("path").get<std::string>());
  const auto value = [&](const nlohmann::json& json) {
    return json.contains(at) ? json.at(at).dump() : std::string("absent");
  };
  const std::size_t more = changes.size() - 1;
  return at.to_string() + " was " + value(old) + " and is " + value(found) +
         (more == 0 ? "" : ", and " + count_text(more, "more value"));
}

}  // namespace slalom
