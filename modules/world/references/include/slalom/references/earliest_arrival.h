// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/references/reference.h>

#include <optional>
#include <string>

namespace slalom {

/// Conditions of an arrival.
struct ArrivalLimits {
  double max_speed = 1;         ///< m/s
  double goal_tolerance = 0.2;  ///< m: whoever is as near to the goal has arrived
  double max_time = 60;         ///< s: later arrivals do not count
};

/// The earliest arrival among the movers of the problem, of a disc that leaves the start at time 0
/// and moves in any direction with at most the maximum speed, knows all movements in advance, and
/// touches neither movers nor static obstacles: no robot that turns, accelerates or senses is
/// earlier. `shortest` is the reference among the static obstacles.
///
/// Upper bound: the arrival of a plan by safe-interval path planning (Phillips and Likhachev 2011,
/// "SIPP: Safe interval path planning for dynamic environments") on the points of the shortest path
/// and of a lattice of half the robot's radius. The plan may wait longer than `stuck_time`.
///
/// Lower bound: the larger one of two. First, the length of the shortest path into the goal region
/// divided by the speed. Let R be the robot's radius and d the tolerance: a straight segment from
/// the goal to a position at most d away keeps sqrt(R^2 - d^2 / 4) from what both ends keep R from.
/// So L - d is a bound, where L is the shortest path of a disc of that radius (of R itself if the
/// clearance at the goal is R + d).
///
/// Second, a search over squares of half diagonal e, for a robot that moves with infinite speed
/// from one to the next. While the true robot is in a square, the center of the square keeps R - e
/// from static obstacles and from movers; at the border it is in both squares at once. So the true
/// motion passes through squares whose centers are safe for a disc smaller by e at that time, and
/// is in a square not before a straight line of the true speed from the start leads there, less e.
/// The search finds the sequence of squares that minimizes, over all its squares, the maximum of
/// the earliest time there and the remaining distance from there, less e, divided by the true
/// speed. Every true motion is one of the sequences considered: its arrival is not earlier.
///
/// Both bounds are equal, but for 1e-6 relative, if no mover is in the way and the goal region is
/// free. The upper bound is infinite, without a plan, if none was found but an arrival is not
/// disproved. nullopt with `reason` if there is no arrival until max_time, which is then proved.
std::optional<EarliestArrival> earliest_arrival(const PlanningProblem& problem,
                                                const ShortestPath& shortest,
                                                const ArrivalLimits& limits, std::string& reason);

/// The first of these lower bounds (s), whatever moves.
double earliest_without_movers(const PlanningProblem& problem, const ShortestPath& shortest,
                               const ArrivalLimits& limits);

/// Adds the earliest arrival, or the reason, to the references of a problem with movers and a
/// shortest path; nothing to others.
void add_earliest_arrival(const PlanningProblem& problem, const ArrivalLimits& limits,
                          References& references);

}  // namespace slalom
