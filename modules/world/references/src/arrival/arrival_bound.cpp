// SPDX-License-Identifier: BSD-3-Clause
#include "../disc_path/occupied_rows.h"
#include "arrival_bound.h"

#include <slalom/core/distance.h>
#include <slalom/references/disc_path.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <queue>

namespace slalom::arrival {
namespace {

using mrpt::math::TPoint2D;

/// Side of the squares as a fraction of the robot's radius.
constexpr double kSideOfRadius = 0.3;
/// Reduction of distances (m) beyond half the diagonal: more than the tolerances of contacts and,
/// at the highest speed of movers, of times.
constexpr double kMargin = 2e-6;
/// Later labels are not examined: the bound found so far is valid, too.
constexpr int kMaxExpanded = 500000;
/// Shortest paths around corners that are computed, at some ms each.
constexpr int kMaxPaths = 50;

/// Radius (m) at which the goal is in sight from all free positions within the tolerance.
double radius_near_goal(const PlanningProblem& problem, const ArrivalLimits& limits) {
  const double square = problem.robot_radius * problem.robot_radius -
                        limits.goal_tolerance * limits.goal_tolerance / 4;
  return square > 0 ? std::sqrt(square) - kMargin : 0;
}

/// A square of the plane: column and row from the one around the start.
struct Square {
  std::int32_t x = 0, y = 0;
};

/// A square in one of the intervals in which its center is safe.
struct SquareState {
  Square square;
  Interval safe;
  double rest = 0;  ///< m, a lower bound of the distance from anywhere in it to the goal region
  bool is_around_corners = false;  ///< rest is
  /// The earliest time of the labels expanded.
  double expanded = std::numeric_limits<double>::infinity();
};

/// A path to a state: the earliest time there, and a lower bound of the arrival (s).
struct Label {
  double bound, rest, t;
  int state;
  bool operator<(const Label& other) const {
    if (bound != other.bound) return bound > other.bound;
    if (rest != other.rest) return rest > other.rest;
    return t != other.t ? t > other.t : state > other.state;
  }
};

class SquareSearch {
 public:
  SquareSearch(const PlanningProblem& problem, const ArrivalLimits& limits, double limit)
      : problem_(problem),
        limits_(limits),
        limit_(limit),
        cells_(problem.world.occupancy()),
        rows_(cells_),
        side_(kSideOfRadius * problem.robot_radius),
        reach_(side_ * std::sqrt(0.5) + kMargin),
        radius_(problem.robot_radius - reach_),
        traffic_(traffic_of(problem.movers(), radius_, limits.max_time)) {}

  double run(double known) {
    for (const int state : states_at({0, 0}))
      if (state_at(state).safe.first <= 0) offer(state, 0, known);
    for (int expanded = 0; !queue_.empty(); ++expanded) {
      const Label label = queue_.top();
      queue_.pop();
      SquareState& state = state_at(label.state);
      if (label.t >= state.expanded) continue;
      if (distance_to_goal(state.square) == 0 || expanded == kMaxExpanded) return label.bound;
      state.expanded = label.t;
      expand(label);
    }
    return limit_;
  }

 private:
  SquareState& state_at(int state) { return states_[static_cast<std::size_t>(state)]; }

  TPoint2D center(const Square& square) const {
    return problem_.start + TPoint2D(square.x, square.y) * side_;
  }

  bool is_free(const TPoint2D& p, const TPoint2D& q) const {
    return disc_path::is_sweep_free(rows_, cells_.to_cells(p), cells_.to_cells(q),
                                    radius_ / cells_.resolution());
  }

  double distance_to_goal(const Square& square) const {
    const double length = distance_between(center(square), problem_.goal);
    return std::max(0.0, length - reach_ - limits_.goal_tolerance);
  }

  const std::vector<int>& states_at(const Square& square) {
    const auto [found, is_new] = states_of_.try_emplace({square.x, square.y});
    const TPoint2D p = center(square);
    if (!is_new || !is_free(p, p)) return found->second;
    for (const Interval& safe : safe_intervals(p, traffic_, limits_.max_time)) {
      found->second.push_back(static_cast<int>(states_.size()));
      states_.push_back({square, safe, distance_to_goal(square)});
    }
    return found->second;
  }

  /// A lower bound (m) of the distance from a square in which the robot waits: it matters most, so
  /// it is also measured around corners.
  double rest_after_waiting(int index) {
    SquareState& state = state_at(index);
    if (state.is_around_corners) return state.rest;
    state.is_around_corners = true;
    const TPoint2D p = center(state.square);
    const double radius = std::min(radius_, radius_near_goal(problem_, limits_));
    if (radius <= 0 || paths_ == kMaxPaths || is_free(p, problem_.goal)) return state.rest;
    ++paths_;
    std::string reason;
    const auto path = shortest_disc_path(cells_, radius, p, problem_.goal, reason);
    const double length = path ? path->length : std::numeric_limits<double>::infinity();
    state.rest = std::max(state.rest, length - reach_ - limits_.goal_tolerance);
    return state.rest;
  }

  void offer(int index, double t, double bound) {
    const SquareState& state = state_at(index);
    bound = std::max(bound, t + state.rest / limits_.max_speed);
    const bool is_of_use = bound < limit_ && bound <= limits_.max_time;
    if (t < state.expanded && is_of_use) queue_.push({bound, state.rest, t, index});
  }

  /// To the four squares that share a border with it; a motion through a corner is in all squares
  /// around it at once.
  void expand(const Label& label) {
    const SquareState from = state_at(label.state);  // states_ grows
    for (const Square& step : {Square{1, 0}, Square{-1, 0}, Square{0, 1}, Square{0, -1}}) {
      const Square square{from.square.x + step.x, from.square.y + step.y};
      const double direct = distance_between(center(square), problem_.start) - reach_;
      const double t = std::max(label.t, direct / limits_.max_speed);
      for (const int next : states_at(square)) {
        const Interval& safe = state_at(next).safe;
        const double at = std::max(t, safe.first);
        if (at > std::min(from.safe.last, safe.last)) continue;
        // At that time the robot is in both squares.
        const double rest = at > t ? rest_after_waiting(label.state) : from.rest;
        offer(next, at, std::max(label.bound, at + rest / limits_.max_speed));
      }
    }
  }

  const PlanningProblem& problem_;
  const ArrivalLimits& limits_;
  double limit_;
  const Occupancy& cells_;
  disc_path::OccupiedRows rows_;
  double side_;
  double reach_;   ///< m, more than from the center of a square to any position in it
  double radius_;  ///< m, of the smaller disc
  Traffic traffic_;
  std::vector<SquareState> states_;
  std::map<std::pair<int, int>, std::vector<int>> states_of_;
  std::priority_queue<Label> queue_;
  int paths_ = 0;
};

}  // namespace

double moving_bound(const PlanningProblem& problem, const ArrivalLimits& limits, double known,
                    double limit) {
  return std::min(limit, SquareSearch(problem, limits, limit).run(known));
}

}  // namespace slalom::arrival

namespace slalom {

double earliest_without_movers(const PlanningProblem& problem, const ShortestPath& shortest,
                               const ArrivalLimits& limits) {
  const double tolerance = limits.goal_tolerance;
  const double clearance = problem.world.distance_field().clearance(problem.goal);
  double length = distance_between(problem.start, problem.goal);
  if (clearance >= problem.robot_radius + tolerance) {
    length = shortest.exact_length;
  } else if (const double radius = arrival::radius_near_goal(problem, limits); radius > 0) {
    std::string reason;
    const auto path =
        shortest_disc_path(problem.world.occupancy(), radius, problem.start, problem.goal, reason);
    if (path) length = path->length;
  }
  return std::max(0.0, length - tolerance) / limits.max_speed;
}

}  // namespace slalom
