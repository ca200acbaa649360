// SPDX-License-Identifier: BSD-3-Clause
#include "solvable.h"

#include <slalom/core/error.h>
#include <slalom/core/random.h>
#include <slalom/references/disc_path.h>
#include <slalom/references/footprint_path.h>
#include <slalom/scenario/widest_path.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace slalom {
namespace {

/// Cells may reach farther than what they represent.
bool starts_in_wall(const World& world) {
  const People& people = world.scenario().people();
  return std::any_of(people.begin(), people.end(), [&](const Person& person) {
    return world.distance_field().clearance(person.start) < person.radius;
  });
}

}  // namespace

bool is_certified(const PlanningProblem& problem, std::string& reason) {
  const World& world = problem.world;
  if (!shortest_disc_path(world.occupancy(), problem.robot_radius, problem.start, problem.goal,
                          reason))
    return false;
  if (widest_bottleneck(world, problem.start, problem.goal) >= problem.robot_radius) return true;
  reason = "no path over cell centers is wide enough for the robot";
  return false;
}

bool is_certified(const World& world, double robot_radius, const std::optional<Footprint>& polygon,
                  std::string& reason) {
  constexpr double kMargin = 0.01;  // m, that methods need beyond what the shape needs
  const mrpt::math::TPose2D& start = world.scenario().start();
  const mrpt::math::TPoint2D& goal = world.scenario().goal();
  if (is_certified({world, robot_radius, {start.x, start.y}, goal}, reason)) return true;
  return polygon && find_footprint_path(world, *polygon, start, goal, kMargin, reason);
}

SolvableWorld SolvableSearch::find(const std::string& name, const Draw& draw,
                                   int first_attempt) const {
  std::map<std::string, int> reasons;
  if (first_attempt > 0) reasons["duplicate of an earlier scenario"] = first_attempt;
  for (int attempt = first_attempt; attempt < settings_.attempts_per_scenario; ++attempt) {
    std::string reason;
    if (std::optional<Scenario> candidate = draw(attempt, reason)) {
      auto world = std::make_unique<const World>(std::move(*candidate), settings_.resolution);
      if (starts_in_wall(*world))
        reason = "a person starts in a wall";
      else if (is_certified(*world, settings_.robot_radius, settings_.footprint, reason))
        return {std::move(world), attempt};
    }
    ++reasons[reason];
  }
  std::string counts;
  for (const auto& [reason, times] : reasons)
    counts += fmt::format("{}{} times: {}", counts.empty() ? "" : "; ", times, reason);
  throw job_error(name,
                  fmt::format("no solvable scenario for {} in {} attempts ({})",
                              settings_.footprint
                                  ? "the robot's footprint"
                                  : fmt::format("a robot of radius {} m", settings_.robot_radius),
                              settings_.attempts_per_scenario, counts),
                  "fewer or smaller obstacles, or a smaller robot");
}

Scenario with_goal_heading(const Scenario& scenario, const GenerationSettings& settings,
                           std::uint64_t seed) {
  if (!settings.goal_headings) return scenario;
  RandomEngine engine(derive_seed(seed, "goal_heading"));
  return scenario.with_goal_heading(uniform_real(engine, -M_PI, M_PI));
}

std::string scenario_name(const std::string& prefix, int index) {
  return fmt::format("{}_{:04}", prefix, index);
}

}  // namespace slalom
