// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/falsification/failure_files.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/io/svg_scene.h>

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

using Json = nlohmann::ordered_json;

SceneTrajectory scene_trajectory(const std::string& name, const Trial& trial, std::size_t index) {
  SceneTrajectory drawn{name, {}, trial.outcome, method_color(index)};
  for (const mrpt::math::TPose2D& pose : trial.waypoints) drawn.path.emplace_back(pose.x, pose.y);
  return drawn;
}

std::string picture(const Failure& failure, const FalsificationSetup& setup) {
  SceneOptions options;
  options.robot_radius = setup.run.robot.shape().enclosing_radius();
  const FairnessReport& fairness = failure.small.fairness;
  options.trajectories = {scene_trajectory(setup.method.name, failure.small.trial, 0)};
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

Json descriptors_json(const Scenario& scenario, const DescribeOptions& options,
                      DescriptorStore& store) {
  Json values = Json::object();
  for (const KeyedValue& value : describe_scenario(scenario, options, store))
    values[value.key.id] =
        value.value.is_na() ? Json({{"na", value.value.reason()}}) : Json(value.value.number());
  return values;
}

/// The failure without its descriptors.
Json failure_json(const Failure& failure, const FalsificationSetup& setup) {
  const ShrinkResult& small = failure.small;
  return {{"name", small.scenario.name()},
          {"scenario", small.scenario.hash()},
          {"method", setup.method.name},
          {"outcome", to_string(small.trial.outcome)},
          {"detail", small.trial.detail},
          {"found", failure.origin},
          {"original_scenario", failure.original.hash()},
          {"smallest_clearance", small.trial.clearance},
          {"trajectory", small.trial.trajectory_hash},
          {"fairness", fairness_json(small.fairness)},
          {"shrinking", shrink_json(small)}};
}

}  // namespace

void write_failures(const std::vector<Failure>& failures, const FalsificationSetup& setup,
                    const DescribeOptions& describe, const std::string& folder,
                    const std::string& search) {
  Json document = {{"method", setup.method.name}};
  if (!search.empty()) document["search"] = Json::parse(search);
  document["failures"] = Json::array();
  ScenarioList::write(folder + "/failures.scenarios", [&](ScenarioList& list) {
    for (const Failure& failure : failures) {
      const Scenario& scenario = failure.small.scenario;
      list.add(scenario, {"", std::nullopt, {to_string(failure.small.trial.outcome)}});
      Json json = failure_json(failure, setup);
      json["descriptors"] = descriptors_json(scenario, describe, list);
      json["show"] = show_command(failure, setup, folder);
      document["failures"].push_back(std::move(json));
      const std::string path = folder + "/" + scenario.name();
      write_file_atomically(path + ".scenario.yaml", scenario_to_yaml(scenario));
      write_file_atomically(path + ".svg", picture(failure, setup) + "\n");
    }
  });
  write_file_atomically(folder + "/failures.json", document.dump(2) + "\n");
}

}  // namespace slalom
