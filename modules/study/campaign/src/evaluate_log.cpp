// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/evaluate_log.h>
#include <slalom/core/distance.h>
#include <slalom/core/text.h>
#include <slalom/simulation/evaluate_trajectory.h>

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

/// s, from the end of a run that was stuck to where the log reaches the goal all the same.
std::optional<double> goal_after(const SimulationResult& run, const Scenario& scenario,
                                 const CampaignOptions& options, const Trajectory& log) {
  if (run.outcome != Outcome::Stuck) return std::nullopt;
  const double end = run.trajectory.samples.back().t;
  for (const Sample& sample : log.samples)
    if (sample.t > end && is_at_goal(scenario, options.simulation, sample.pose))
      return sample.t - end;
  return std::nullopt;
}

std::vector<std::string> position_notes(const World& world, const CampaignOptions& options,
                                        const Trajectory& log, const SimulationResult& run) {
  std::vector<std::string> notes;
  const auto& start = world.scenario().start();
  const auto& first = log.samples.front().pose;
  const double offset = length({{start.x, start.y}, {first.x, first.y}});
  if (offset > options.simulation.goal_tolerance)
    notes.push_back("the log begins " + format_fixed(offset, 2) +
                    " m from the scenario's start, where the references begin");
  const double rest = log.duration() - run.trajectory.duration();
  if (rest > 0)
    notes.push_back("the last " + format_fixed(rest, 2) +
                    " s of the log are left out: " + run.detail);
  if (const auto later = goal_after(run, world.scenario(), options, log))
    notes.push_back("the log reaches the goal " + format_fixed(*later, 2) +
                    " s later: it begins before the run, or the robot waits");
  return notes;
}

}  // namespace

EvaluatedLog evaluate_log(const CampaignOptions& options, const ReferencePlanner* planner,
                          const World& world, const Trajectory& log,
                          std::optional<Outcome> outcome) {
  EvaluatedLog evaluated;
  SimulationResult& run = evaluated.run;
  const References references = find_references(options, planner, world);
  SimulationOptions simulation = options.simulation;
  simulation.max_time = time_limit(options, references);
  if (outcome) {
    run.outcome = *outcome;
    run.detail = "as given";
    run.trajectory = log;
    run.movers =
        movers_along(world, options.robot, simulation, log, options.people, &run.hindrances);
  } else {
    run = evaluate_trajectory(world, options.robot, simulation, log, options.people);
  }
  evaluated.notes = position_notes(world, options, log, run);
  evaluated.metrics = measure_run(options, world, references, run.trajectory, run.outcome,
                                  run.movers, run.hindrances);
  return evaluated;
}

std::string render_json(const EvaluatedLog& log, const Scenario& scenario) {
  using Json = nlohmann::ordered_json;
  Json metrics = Json::object();
  for (const auto& [id, versioned] : log.metrics) {
    const Value& value = versioned.value;
    metrics[id] = value.is_na() ? Json{{"na", value.reason()}} : Json{{"value", value.number()}};
    metrics[id]["version"] = versioned.version;
  }
  const Json json = {{"scenario", {{"hash", scenario.hash()}, {"name", scenario.name()}}},
                     {"outcome", to_string(log.run.outcome)},
                     {"outcome_detail", log.run.detail},
                     {"trajectory", log.run.trajectory.hash()},
                     {"notes", log.notes},
                     {"metrics", metrics}};
  return json.dump();
}

}  // namespace slalom
