// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/measure.h>
#include <slalom/core/random.h>
#include <slalom/metrics/metric.h>
#include <slalom/people/run_alone.h>
#include <slalom/references/earliest_arrival.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace slalom {
namespace {

MetricContext context_of(const CampaignOptions& options, const World& world,
                         const References& references, const Trajectory& trajectory,
                         Outcome outcome, const Movers& movers) {
  return make_metric_context(world, options.robot, trajectory, outcome, references,
                             options.simulation.max_time, options.simulation.goal_tolerance,
                             options.safe_distance, &movers);
}

/// All that moves in each run, whatever the robot does; nullopt without people, or if one of them
/// may notice the robot.
std::optional<Movers> motions_in_each_run(const CampaignOptions& options, const World& world) {
  const Scenario& scenario = world.scenario();
  const bool is_noticed =
      std::any_of(scenario.people().begin(), scenario.people().end(), [&](const Person& person) {
        return notices_robot(scenario.hash(), person.id, options.people.notices);
      });
  if (scenario.people().empty() || is_noticed) return std::nullopt;
  Movers movers = scenario.movers();
  for (Mover& person :
       run_alone(world, scenario.people(), options.people, options.simulation.max_time))
    movers.push_back(std::move(person));
  return movers;
}

}  // namespace

References find_references(const CampaignOptions& options, const ReferencePlanner* planner,
                           const World& world) {
  const Scenario& scenario = world.scenario();
  // For a polygon, the inscribed disc: it fits wherever the polygon fits, so no run can be shorter
  // than the reference.
  const std::optional<Movers> present = motions_in_each_run(options, world);
  const PlanningProblem problem{world,
                                options.robot.shape().inscribed_radius(),
                                {scenario.start().x, scenario.start().y},
                                scenario.goal(),
                                scenario.start().phi,
                                present ? &*present : nullptr};
  References references =
      compute_references(problem, planner, options.reference_gap,
                         derive_seed(options.seed, "reference/" + scenario.hash()));
  const SimulationOptions& simulation = options.simulation;
  add_earliest_arrival(
      problem, {options.robot.max_v, simulation.goal_tolerance, simulation.max_time}, references);
  return references;
}

std::string bound_violation(const CampaignOptions& options, const World& world,
                            const References& references, const Trajectory& trajectory,
                            Outcome outcome) {
  return bound_violation(
      context_of(options, world, references, trajectory, outcome, world.scenario().movers()));
}

std::map<std::string, VersionedValue> measure_run(const CampaignOptions& options,
                                                  const World& world, const References& references,
                                                  const Trajectory& trajectory, Outcome outcome,
                                                  const Movers& movers,
                                                  const Hindrances& hindrances) {
  MetricContext context = context_of(options, world, references, trajectory, outcome, movers);
  context.hindrances = hindrances;
  std::map<std::string, VersionedValue> values;
  for (const std::string& id : options.metrics) {
    const Metric& enabled = metric(id);
    values[id] = {enabled.info.version, enabled.compute(context)};
  }
  return values;
}

}  // namespace slalom
