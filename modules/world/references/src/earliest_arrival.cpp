// SPDX-License-Identifier: BSD-3-Clause
#include "arrival/arrival_bound.h"
#include "arrival/arrival_lattice.h"
#include "arrival/safe_interval_search.h"
#include "wall_time.h"

#include <slalom/core/text.h>
#include <slalom/references/earliest_arrival.h>

#include <limits>

namespace slalom {
namespace {

using arrival::GoalRegion;
using arrival::Roadmap;
using arrival::Stay;
using arrival::Traffic;

/// Spacing of the lattice, as a fraction of the robot's radius.
constexpr double kSpacingOfRadius = 0.5;

std::vector<TimedPoint> find_plan(const PlanningProblem& problem, const ShortestPath& shortest,
                                  const Traffic& traffic, const ArrivalLimits& limits) {
  const GoalRegion region{problem.goal, limits.goal_tolerance};
  const double spacing = kSpacingOfRadius * problem.robot_radius;
  arrival::Lattice lattice(problem.world.occupancy(), problem.robot_radius,
                           resample(region.cut(shortest.path), spacing), region, spacing);
  Roadmap roadmap;
  roadmap.position = [&](int node) { return lattice.position(node); };
  roadmap.neighbors = [&](int node) { return lattice.neighbors(node); };
  roadmap.is_goal = [&](int node) { return region.contains(lattice.position(node)); };
  roadmap.rest = [&](int node) { return region.distance(lattice.position(node)); };
  std::vector<TimedPoint> plan;
  for (const Stay& stay :
       search_safe_intervals(roadmap, traffic, limits.max_speed, limits.max_time)) {
    plan.push_back({stay.arrival, lattice.position(stay.node)});
    if (stay.departure > stay.arrival) plan.push_back({stay.departure, plan.back().position});
  }
  return plan;
}

}  // namespace

std::optional<EarliestArrival> earliest_arrival(const PlanningProblem& problem,
                                                const ShortestPath& shortest,
                                                const ArrivalLimits& limits, std::string& reason) {
  const std::string within = " within " + format_number(limits.max_time) + " s";
  const Traffic traffic =
      arrival::traffic_of(problem.movers(), problem.robot_radius, limits.max_time);
  const auto at_start = safe_intervals(problem.start, traffic, limits.max_time);
  if (at_start.empty() || at_start.front().first > 0) {
    reason = "a moving obstacle touches the robot where it starts";
    return std::nullopt;
  }
  EarliestArrival result;
  Certificate& certificate = result.certificate;
  certificate.lower_bound = earliest_without_movers(problem, shortest, limits);
  if (certificate.lower_bound > limits.max_time) {
    reason = "the goal cannot be reached" + within + ", even without moving obstacles";
    return std::nullopt;
  }
  result.plan = find_plan(problem, shortest, traffic, limits);
  certificate.upper_bound =
      result.plan.empty() ? std::numeric_limits<double>::infinity() : result.plan.back().t;
  certificate.lower_bound = std::min(
      certificate.upper_bound,
      arrival::moving_bound(problem, limits, certificate.lower_bound, certificate.upper_bound));
  if (certificate.lower_bound == std::numeric_limits<double>::infinity()) {
    reason = "there is no arrival among the moving obstacles" + within;
    return std::nullopt;
  }
  return result;
}

void add_earliest_arrival(const PlanningProblem& problem, const ArrivalLimits& limits,
                          References& references) {
  if (!references.shortest || problem.movers().empty()) return;
  references.timing.arrival = wall_time_of([&] {
    references.arrival =
        earliest_arrival(problem, *references.shortest, limits, references.arrival_reason);
  });
}

}  // namespace slalom
