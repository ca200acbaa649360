// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/references/disc_path.h>
#include <slalom/references/turning_bound.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <queue>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Initial heading and curvature of a car.
struct Car {
  double heading = 0;  ///< rad
  double radius = 0;   ///< m, minimum turning radius
  bool reversible = false;

  /// Smallest angle by which it must turn to move in a direction (rad).
  double turn_to(double direction) const {
    const double turn = std::abs(mrpt::math::wrapToPi(direction - heading));
    return reversible ? std::min(turn, M_PI - turn) : turn;
  }
  /// How far it can proceed in a direction by a path of length l (m).
  double max_progress(double direction, double l) const {
    const double turn = turn_to(direction), turned = l / radius;
    if (turned < turn) return radius * (math::sin(turn) - math::sin(turn - turned));
    return radius * math::sin(turn) + l - radius * turn;
  }
};

/// Positions within `half` of the center in x and y.
struct PositionSquare {
  double bound = 0;  ///< lower bound of the path length through them, m
  TPoint2D center;
  double half = 0;  ///< m

  /// The next is the one of the lowest bound, the smallest of several.
  bool operator<(const PositionSquare& other) const {
    return bound > other.bound || (bound == other.bound && half > other.half);
  }
};

/// Branch and bound over the positions after a length l.
class PositionSearch {
 public:
  PositionSearch(const PlanningProblem& problem, const Car& car, double l, double known)
      : problem_(problem), car_(car), l_(l), known_(known) {}

  double minimum() {
    offer({known_, problem_.start, l_});
    while (!open_.empty()) {
      const PositionSquare square = open_.top();
      if (square.half <= kMinHalf || evaluations_ >= kMaxEvaluations) return square.bound;
      open_.pop();
      const double half = 0.5 * square.half;
      for (const double x : {-half, half})
        for (const double y : {-half, half})
          offer({square.bound, square.center + TPoint2D(x, y), half});
    }
    return known_;  // not reached: the car's own path is in one of the squares
  }

 private:
  static constexpr double kMinHalf = 0.005;  ///< m
  static constexpr int kMaxEvaluations = 400;
  static constexpr int kDirections = 64;

  bool is_reachable(const TPoint2D& p, double margin) const {
    for (int i = 0; i < kDirections; ++i) {
      const double direction = 2 * M_PI * i / kDirections;
      const TPoint2D moved = p - problem_.start;
      const double progress = moved.x * math::cos(direction) + moved.y * math::sin(direction);
      if (progress > car_.max_progress(direction, l_) + margin) return false;
    }
    return true;
  }

  /// Adds a square unless the car is in none of its positions after l.
  void offer(PositionSquare square) {
    const double margin = square.half * M_SQRT2;
    if (!is_reachable(square.center, margin)) return;
    if (margin < 0.5 * problem_.robot_radius) {
      ++evaluations_;
      std::string reason;
      const auto rest =
          shortest_disc_path(problem_.world.occupancy(), problem_.robot_radius - margin,
                             square.center, problem_.goal, reason);
      if (!rest) return;
      square.bound = std::max(square.bound, l_ + rest->length - margin);
    }
    open_.push(square);
  }

  const PlanningProblem& problem_;
  Car car_;
  double l_, known_;
  std::priority_queue<PositionSquare> open_;
  int evaluations_ = 0;
};

/// The length of the shortest curve of a car that drives forward only to a position in its frame,
/// in any heading: an arc and a straight line, or less than 0 if the position lies within a turning
/// circle, to which other curves lead (Bui et al. 1994, "Shortest path synthesis for Dubins
/// non-holonomic robot").
double arc_and_line(const TPoint2D& goal, double radius) {
  double shortest = -1;
  for (const double side : {1.0, -1.0}) {
    const TPoint2D from_center(goal.x, side * goal.y - radius);
    const double square =
        from_center.x * from_center.x + from_center.y * from_center.y - radius * radius;
    if (square < 0) return -1;
    const double line = std::sqrt(square);
    const double angle = math::atan2(from_center.y, from_center.x) + math::atan2(radius, line);
    constexpr double kRounding = 1e-9;
    const double turn = angle < -kRounding ? angle + 2 * M_PI : std::max(angle, 0.0);
    const double length = radius * turn + line;
    if (shortest < 0 || length < shortest) shortest = length;
  }
  return shortest;
}

}  // namespace

double obstacle_free_bound(const PlanningProblem& problem, double min_turning_radius,
                           bool reversible) {
  const Car car{problem.start_heading, min_turning_radius, reversible};
  const TPoint2D to_goal = problem.goal - problem.start;
  double bound = distance_between(problem.goal, problem.start);
  constexpr int kDirections = 3600;  // each gives a bound
  for (int i = 0; i < kDirections; ++i) {
    const double direction = 2 * M_PI * i / kDirections;
    const double progress = to_goal.x * math::cos(direction) + to_goal.y * math::sin(direction);
    const double turn = car.turn_to(direction);
    // A path that proceeds as far has turned completely: it is longer than the turn.
    if (progress <= min_turning_radius * math::sin(turn)) continue;
    bound = std::max(bound, progress + min_turning_radius * (turn - math::sin(turn)));
  }
  if (reversible) return bound;
  const double c = math::cos(problem.start_heading), s = math::sin(problem.start_heading);
  const TPoint2D in_frame(c * to_goal.x + s * to_goal.y, c * to_goal.y - s * to_goal.x);
  return std::max(bound, arc_and_line(in_frame, min_turning_radius));
}

double turning_lower_bound(const PlanningProblem& problem, const ShortestPath& exact,
                           double min_turning_radius, bool reversible) {
  const double known = std::max(exact.certificate.lower_bound,
                                obstacle_free_bound(problem, min_turning_radius, reversible));
  if (exact.path.size() < 2) return known;
  const TPoint2D first = exact.path[1] - exact.path[0];
  const Car car{problem.start_heading, min_turning_radius, reversible};
  const double turn = car.turn_to(math::atan2(first.y, first.x));
  constexpr double kMinTurn = 0.05;  // rad; the cube of it is lost
  if (turn < kMinTurn) return known;
  const double l = std::min(min_turning_radius * turn, known);
  return PositionSearch(problem, car, l, known).minimum();
}

}  // namespace slalom
