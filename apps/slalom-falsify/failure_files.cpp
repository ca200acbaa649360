// SPDX-License-Identifier: BSD-3-Clause
#include "failure_files.h"

#include <slalom/app/output_folder.h>
#include <slalom/campaign/describe_scenario.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/io/svg_scene.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>

namespace slalom {
namespace {

using Json = nlohmann::ordered_json;

SceneTrajectory scene_trajectory(const std::string& name, const Trial& trial, std::size_t index) {
  SceneTrajectory drawn{name, {}, trial.outcome, method_color(index)};
  for (const mrpt::math::TPose2D& pose : trial.waypoints) drawn.path.emplace_back(pose.x, pose.y);
  return drawn;
}

std::string picture(const Failure& failure, const TestBench& bench) {
  SceneOptions options;
  options.robot_radius = bench.setup.robot.shape().enclosing_radius();
  const FairnessReport& fairness = failure.small.fairness;
  options.trajectories = {scene_trajectory(bench.method.name, failure.small.trial, 0)};
  if (!fairness.witness.empty())
    options.trajectories.push_back(scene_trajectory(fairness.witness, fairness.witness_run, 1));
  return render_svg(failure.small.scenario, options);
}

Json fairness_json(const FairnessReport& fairness) {
  return {{"fair", fairness.fair()},
          {"violations", fairness.violations},
          {"bottleneck_robot_widths", fairness.geometry.bottleneck},
          {"start_clearance", fairness.geometry.start_clearance},
          {"distance", fairness.geometry.distance},
          {"witness", fairness.witness.empty() ? Json() : Json(fairness.witness)},
          {"repeatable", fairness.repeatable}};
}

Json shrink_json(const ShrinkResult& small) {
  Json removals = Json::array();
  for (const Removal& removal : small.removals)
    removals.push_back({{"part", removal.part}, {"verdict", removal.verdict}});
  return {{"parts_before", small.parts_before},
          {"parts_after", small.parts_after},
          {"runs", small.runs},
          {"refused_by_geometry", small.unfair},
          {"end_moved", small.moved},
          {"minimal", small.minimal},
          {"removals", removals}};
}

Json descriptors_json(const Scenario& scenario, const CampaignOptions& options,
                      DescriptorStore& store) {
  DescribeOptions describe;
  describe.ids = options.descriptors;
  describe.robot = options.robot.shape();
  describe.sensor_range = options.sensor.max_range;
  describe.resolution = options.simulation.resolution;
  describe.exact_confinement = options.exact_confinement;
  Json values = Json::object();
  for (const KeyedValue& value : describe_scenario(scenario, describe, store))
    values[value.key.id] =
        value.value.is_na() ? Json({{"na", value.value.reason()}}) : Json(value.value.number());
  return values;
}

Json failure_json(const Failure& failure, const FalsifyCampaign& campaign,
                  const std::string& folder, DescriptorStore& store) {
  const ShrinkResult& small = failure.small;
  return {{"name", small.scenario.name()},
          {"scenario", small.scenario.hash()},
          {"method", campaign.bench.method.name},
          {"outcome", to_string(small.trial.outcome)},
          {"detail", small.trial.detail},
          {"found", failure.origin},
          {"original_scenario", failure.original.hash()},
          {"smallest_clearance", small.trial.clearance},
          {"trajectory", small.trial.trajectory_hash},
          {"fairness", fairness_json(small.fairness)},
          {"shrinking", shrink_json(small)},
          {"descriptors", descriptors_json(small.scenario, campaign.config.options, store)},
          {"show", show_command(failure, campaign.bench, folder)}};
}

}  // namespace

IniFile ini_of_list(const FalsifyCampaign& campaign, const std::string& list_path,
                    RecordedRuns rawlogs) {
  IniFile ini = campaign.ini;
  for (const std::string& section : campaign.ini.sections())
    if (section == "scenarios" || starts_with(section, "generator."))
      for (const std::string& key : campaign.ini.keys(section)) ini.remove(section, key);
  const auto list = std::filesystem::absolute(list_path).lexically_normal();
  ini.set("scenarios", "list", list.string());
  ini.set("campaign", "repetitions", std::to_string(campaign.bench.repetition + 1));
  ini.set("record", "rawlog", to_string(rawlogs));
  ini.set("record", "trajectories", to_string(StoredTrajectories::All));
  // Files that were found where the .ini is or in the current folder, where the copy may not be.
  for (const auto& [key, path] : campaign.config.method_files)
    if (std::filesystem::exists(path)) {
      const std::size_t dot = key.rfind('.');
      ini.set(key.substr(0, dot), key.substr(dot + 1), std::filesystem::absolute(path).string());
    }
  return ini;
}

void name_failures(std::vector<Failure>& failures, const std::string& method) {
  std::map<std::string, int> counts;
  for (Failure& failure : failures) {
    const std::string kind = method + "_" + to_string(failure.small.trial.outcome);
    failure.small.scenario =
        failure.small.scenario.renamed(kind + "_" + std::to_string(++counts[kind]));
  }
}

void write_failures(const std::vector<Failure>& failures, const FalsifyCampaign& campaign,
                    const std::string& folder, const std::string& search) {
  make_output_folder(folder);
  Json document = {{"method", campaign.bench.method.name}};
  if (!search.empty()) document["search"] = Json::parse(search);
  document["failures"] = Json::array();
  ScenarioList::write(folder + "/failures.scenarios", [&](ScenarioList& list) {
    for (const Failure& failure : failures) {
      const Scenario& scenario = failure.small.scenario;
      list.add(scenario, {"", std::nullopt, {to_string(failure.small.trial.outcome)}});
      document["failures"].push_back(failure_json(failure, campaign, folder, list));
      const std::string path = folder + "/" + scenario.name();
      write_file_atomically(path + ".scenario.yaml", scenario_to_yaml(scenario));
      write_file_atomically(path + ".svg", picture(failure, campaign.bench) + "\n");
    }
  });
  const IniFile ini = ini_of_list(campaign, folder + "/failures.scenarios", RecordedRuns::All);
  write_file_atomically(folder + "/failures.ini", ini.canonical_text());
  write_file_atomically(folder + "/failures.json", document.dump(2) + "\n");
}

}  // namespace slalom
