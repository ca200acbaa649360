// SPDX-License-Identifier: BSD-3-Clause
#include "obstacle_parts.h"
#include "shrinker.h"

#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/falsification/shrink.h>

#include <algorithm>
#include <tuple>

namespace slalom {
namespace {

constexpr int kMaxRounds = 5;

bool any_witness_succeeds(TrialSource& trials, const FalsificationSetup& setup,
                          const World& world) {
  for (const std::size_t i : setup.witnesses_in(world.scenario()))
    if (trials.trial(world, i).outcome == Outcome::Success) return true;
  return false;
}

/// The conditions that the smallest scenario must meet: those of the options, but not more than the
/// original does, or nothing could be changed.
FairnessOptions attainable(const FairnessOptions& wanted, TrialSource& trials,
                           const FalsificationSetup& setup, const World& original) {
  const RobotModel& robot = setup.run.robot;
  const GeometryReport geometry = judge_geometry(original, robot, wanted);
  FairnessOptions options = wanted;
  options.min_bottleneck = std::min(wanted.min_bottleneck, geometry.bottleneck);
  options.min_start_clearance = std::min(wanted.min_start_clearance, geometry.start_clearance);
  options.min_distance = std::min(wanted.min_distance, geometry.distance);
  options.people_walk =
      wanted.people_walk && problem_of_people(original, robot.shape().enclosing_radius()).empty();
  if (!any_witness_succeeds(trials, setup, original)) options.witness = NeedsWitness::Never;
  return options;
}

bool one_round(Shrinker& shrinker) {
  bool changed = remove_obstacles(shrinker);
  changed |= move_start_and_goal(shrinker);
  changed |= crop_workspace(shrinker);
  changed |= remove_obstacles(shrinker);
  changed |= shorten_routes(shrinker);
  changed |= simplify_shapes(shrinker);
  changed |= round_numbers(shrinker);
  return changed;
}

double distance_of_ends(const Trial& a, const Trial& b) {
  if (a.waypoints.empty() || b.waypoints.empty()) return 0;
  return distance_between(a.waypoints.back(), b.waypoints.back());
}

std::size_t count_parts(const Scenario& scenario, double resolution) {
  return ObstacleParts(scenario, 0, resolution).size();
}

/// The computation, which depends only on trials.
ShrinkResult shrink_with(TrialSource& trials, const FalsificationSetup& setup,
                         const Scenario& original, const ShrinkOptions& options) {
  const World world(original, setup.run.simulation.resolution);
  const Trial failure = trials.trial(world, 0);
  if (failure.outcome == Outcome::Success)
    throw job_error("scenario " + original.name(), setup.method.name + " reaches the goal in it",
                    "a scenario in which it fails");
  FailureTest test(trials, setup, failure.outcome,
                   attainable(options.fairness, trials, setup, world), options.max_runs);
  Shrinker shrinker(test, original, setup);
  for (int round = 0; round < kMaxRounds && one_round(shrinker); ++round) continue;
  const RemovalRound last = remove_each_once(shrinker);
  ShrinkResult result{shrinker.scenario(), shrinker.trial()};
  for (const auto& [part, verdict] : last.removals)
    result.removals.push_back({part, verdict.reason});
  result.minimal = last.minimal;
  result.parts_before = count_parts(original, shrinker.resolution());
  result.parts_after = count_parts(result.scenario, shrinker.resolution());
  result.runs = test.runs();
  result.unfair = test.unfair();
  result.moved = distance_of_ends(failure, result.trial);
  return result;
}

}  // namespace

bool is_simpler(const ShrinkResult& a, const ShrinkResult& b) {
  const auto key = [](const ShrinkResult& small) {
    const GeometryReport& geometry = small.fairness.geometry;
    return std::make_tuple(small.parts_after, -geometry.bottleneck, geometry.distance);
  };
  return key(a) < key(b);
}

std::optional<ShrinkResult> shrink(const FalsificationSetup& setup, const Scenario& scenario,
                                   const ShrinkOptions& options) {
  std::optional<ShrinkResult> result;
  std::size_t begun = 0;
  IsolatedTrials trials(setup, [&] {
    if (options.on_runs && trials.begun() > begun) options.on_runs(begun = trials.begun());
    return options.interrupted && options.interrupted();
  });
  if (!trials.execute(
          [&](TrialSource& source) { result = shrink_with(source, setup, scenario, options); }))
    return std::nullopt;
  result->fairness = judge_failure(setup, result->scenario, result->trial, options.fairness);
  return result;
}

}  // namespace slalom
