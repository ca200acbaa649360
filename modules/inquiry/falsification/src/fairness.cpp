// SPDX-License-Identifier: BSD-3-Clause
#include "isolated_trials.h"

#include <slalom/campaign/measure.h>
#include <slalom/core/distance.h>
#include <slalom/core/text.h>
#include <slalom/falsification/fairness.h>
#include <slalom/scenario/widest_path.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kRounding = 1e-9;

/// In robot widths. widest_bottleneck() is that of points at most a cell's diagonal apart, and the
/// distance to obstacles changes by at most the distance traveled: between two of them it is less
/// by at most half of that.
double certified(double widest, const World& world, double radius) {
  return std::max(0.0, widest - world.occupancy().resolution() * M_SQRT1_2) / radius;
}

/// People count as obstacles if they are there when the run begins.
double start_clearance(const World& world, double radius) {
  const auto& start = world.scenario().start();
  double clearance = world.distance_field().clearance({start.x, start.y});
  for (const Person& person : world.scenario().people())
    if (person.begin <= 0)
      clearance = std::min(clearance, distance_between(person.start, start) - person.radius);
  return clearance - radius;
}

std::string below(const char* what, double value, double limit, const char* unit) {
  return std::string(what) + " " + format_fixed(value, 3) + " " + unit + ", less than " +
         format_fixed(limit, 3);
}

std::string without_witness(const FalsificationSetup& setup,
                            const std::vector<std::size_t>& witnesses) {
  if (witnesses.empty()) return "no witness is named";
  if (witnesses.back() != setup.unnoticed_index()) return "no witness reaches the goal";
  return "not proved solvable: no witness reaches the goal, nor " +
         setup.witness_name(setup.unnoticed_index());
}

}  // namespace

GeometryReport judge_geometry(const World& world, const RobotModel& robot,
                              const FairnessOptions& options) {
  const Scenario& scenario = world.scenario();
  const auto& start = scenario.start();
  const double radius = robot.shape().enclosing_radius();
  GeometryReport report;
  report.distance = distance_between(scenario.goal(), start);
  report.start_clearance = start_clearance(world, radius);
  report.bottleneck = certified(widest_bottleneck(world, {start.x, start.y}, scenario.goal()),
                                world, passing_radius(radius, robot.turning_polygon()));
  if (report.distance < options.min_distance - kRounding)
    report.violation = below("distance to the goal", report.distance, options.min_distance, "m");
  else if (report.start_clearance < options.min_start_clearance - kRounding)
    report.violation =
        below("clearance at the start", report.start_clearance, options.min_start_clearance, "m");
  else if (report.bottleneck < options.min_bottleneck - kRounding)
    report.violation =
        below("bottleneck", report.bottleneck, options.min_bottleneck, "robot widths");
  else if (options.people_walk)
    report.violation = problem_of_people(world, radius);
  return report;
}

bool has_fair_geometry(const World& world, const RobotModel& robot,
                       const FairnessOptions& options) {
  const Scenario& scenario = world.scenario();
  const auto& start = scenario.start();
  const double radius = robot.shape().enclosing_radius(),
               passing = passing_radius(radius, robot.turning_polygon());
  if (distance_between(scenario.goal(), start) < options.min_distance - kRounding) return false;
  if (start_clearance(world, radius) < options.min_start_clearance - kRounding) return false;
  if (options.people_walk && !problem_of_people(world, radius).empty()) return false;
  const auto suffices = [&](double widest) {
    return certified(widest, world, passing) >= options.min_bottleneck - kRounding;
  };
  if (suffices(0)) return true;
  // The smallest number that suffices, so that both functions agree to the last bit.
  double width =
      (options.min_bottleneck - kRounding) * passing + world.occupancy().resolution() * M_SQRT1_2;
  const auto next = [&width](double towards) { return std::nextafter(width, towards); };
  while (!suffices(width)) width = next(2 * width);
  while (suffices(next(0))) width = next(0);
  return has_bottleneck(world, {start.x, start.y}, scenario.goal(), width);
}

bool needs_witness(const FairnessOptions& options, const Scenario& scenario, Outcome outcome) {
  if (options.witness != NeedsWitness::NotForOwn) return options.witness == NeedsWitness::Always;
  const bool moves = !scenario.movers().empty() || !scenario.people().empty();
  return outcome == Outcome::Stuck || outcome == Outcome::Timeout ||
         (outcome == Outcome::Collision && moves);
}

FairnessReport judge_failure(const FalsificationSetup& setup, const Scenario& scenario,
                             const Trial& failure, const FairnessOptions& options) {
  FairnessReport report;
  const World world(scenario, setup.run.simulation.resolution);
  report.geometry = judge_geometry(world, setup.run.robot, options);
  if (!report.geometry.violation.empty()) report.violations.push_back(report.geometry.violation);
  if (std::string lack = lack_of_time(setup.run, world, find_earliest(setup.run, world));
      !lack.empty())
    report.violations.push_back(std::move(lack));
  const std::vector<std::size_t> witnesses = setup.witnesses_in(scenario);
  for (const std::size_t i : witnesses) {
    Trial run = run_alone(setup, scenario, i);
    if (run.outcome != Outcome::Success) continue;
    report.witness = setup.witness_name(i);
    report.witness_run = std::move(run);
    break;
  }
  if (report.witness.empty() && needs_witness(options, scenario, failure.outcome))
    report.violations.push_back(without_witness(setup, witnesses));
  report.repeatable = is_same_run(failure, run_alone(setup, scenario, 0));
  if (options.repeatable && !report.repeatable)
    report.violations.emplace_back("a new process does not repeat the run");
  return report;
}

}  // namespace slalom
