// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/measure.h>
#include <slalom/core/random.h>
#include <slalom/core/text.h>
#include <slalom/metrics/metric.h>
#include <slalom/people/run_alone.h>
#include <slalom/references/earliest_arrival.h>
#include <slalom/references/exact_shortest.h>
#include <slalom/references/footprint_path.h>
#include <slalom/results/lack_of_time.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace slalom {
namespace {

/// s, in which the robot drives that far (m) from standing.
double least_time(double length, const RobotModel& robot) {
  const double v = robot.max_v, a = robot.max_accel_v, to_speed = v * v / (2 * a);
  return robot.delay + (length < to_speed ? std::sqrt(2 * length / a) : length / v + v / (2 * a));
}

MetricContext context_of(const CampaignOptions& options, const World& world,
                         const References& references, const Trajectory& trajectory,
                         Outcome outcome, const Movers& movers) {
  return make_metric_context(world, options.robot, trajectory, outcome, references,
                             time_limit(options, references), options.simulation.goal_tolerance,
                             options.safe_distance, &movers);
}

/// All that moves in each run, whatever the robot does; nullopt without people, or if one of them
/// may notice the robot.
std::optional<Movers> motions_in_each_run(const RunSetup& setup, const World& world, double until) {
  const Scenario& scenario = world.scenario();
  const bool is_noticed =
      std::any_of(scenario.people().begin(), scenario.people().end(), [&](const Person& person) {
        return notices_robot(scenario.hash(), person.id, setup.people.notices);
      });
  if (scenario.people().empty() || is_noticed) return std::nullopt;
  Movers movers = scenario.movers();
  for (Mover& person : run_alone(world, scenario.people(), setup.people, until))
    movers.push_back(std::move(person));
  return movers;
}

/// For a polygon, the inscribed disc: it fits wherever the polygon fits, so no run can be shorter
/// than the reference.
PlanningProblem problem_of(const RunSetup& setup, const World& world) {
  const Scenario& scenario = world.scenario();
  return {world,
          setup.robot.shape().inscribed_radius(),
          {scenario.start().x, scenario.start().y},
          scenario.goal(),
          scenario.start().phi};
}

/// Within the time limit that follows from the shortest path.
void add_arrival(const RunSetup& setup, PlanningProblem problem, References& references) {
  const double limit = time_limit(setup, references);
  const std::optional<Movers> present = motions_in_each_run(setup, problem.world, limit);
  if (present) problem.present = &*present;
  add_earliest_arrival(problem, {setup.robot.max_v, setup.simulation.goal_tolerance, limit},
                       references);
}

}  // namespace

References find_references(const CampaignOptions& options, const ReferencePlanner* planner,
                           const World& world) {
  const PlanningProblem problem = problem_of(options, world);
  References references =
      compute_references(problem, planner, options.reference_gap,
                         derive_seed(options.seed, "reference/" + world.scenario().hash()));
  refuse_obstructed(problem, options.robot.shape(), options.simulation.goal_tolerance, references);
  add_arrival(options, problem, references);
  return references;
}

References find_earliest(const RunSetup& setup, const World& world) {
  const PlanningProblem problem = problem_of(setup, world);
  References references;
  references.shortest = exact_shortest_path(problem, references.shortest_reason);
  if (!setup.simulation.max_time) add_arrival(setup, problem, references);
  return references;
}

double time_limit(const RunSetup& setup, const References& references) {
  if (!references.shortest) return setup.simulation.time_limit();
  double earliest = references.shortest->exact_length / setup.robot.max_v;
  if (references.arrival)
    earliest = std::max(earliest, references.arrival->certificate.lower_bound);
  return setup.simulation.time_limit(earliest);
}

bool may_lack_time(const RunSetup& setup, const References& references) {
  return references.shortest &&
         least_time(references.shortest->exact_length, setup.robot) > time_limit(setup, references);
}

std::string lack_of_time(const RunSetup& setup, const World& world, const References& references) {
  if (!may_lack_time(setup, references)) return "";
  const double limit = time_limit(setup, references), speed = setup.robot.max_v;
  const double at_speed = earliest_without_movers(problem_of(setup, world), *references.shortest,
                                                  {speed, setup.simulation.goal_tolerance, limit});
  const double earliest = least_time(at_speed * speed, setup.robot);
  if (earliest <= limit) return "";
  return lack_of_time_sentence(limit, earliest, speed);
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
