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

double positive_angle(double angle) {
  return angle < 0 ? angle + 2 * M_PI : angle;
}

/// The length of an arc to the left and a straight line to a position, m. The frame is that of the
/// car about the center of the left turning circle, outside of which the position lies.
double arc_and_line(const TPoint2D& goal, double radius) {
  const double line = std::sqrt(std::max(0.0, goal.sqrNorm() - radius * radius));
  const double angle = math::atan2(goal.y, goal.x) + math::atan2(radius, line);
  constexpr double kRounding = 1e-9;
  const double turn = angle < -kRounding ? angle + 2 * M_PI : std::max(angle, 0.0);
  return radius * turn + line;
}

/// The length of an arc to the left and one to the right to the same, m; infinity if it is farther
/// than these lead. The center of the second circle is 2 radii from the first one and 1 from it.
double arc_and_arc(const TPoint2D& goal, double radius) {
  const double distance = goal.norm();
  if (distance > 3 * radius) return HUGE_VAL;
  const double cosine = (distance * distance + 3 * radius * radius) / (4 * radius * distance);
  const double between = math::acos(std::min(1.0, cosine));
  double shortest = HUGE_VAL;
  for (const double side : {1.0, -1.0}) {
    const double to_center = math::atan2(goal.y, goal.x) + side * between;
    const TPoint2D center(2 * radius * math::cos(to_center), 2 * radius * math::sin(to_center));
    const double to_goal = math::atan2(goal.y - center.y, goal.x - center.x);
    const double left = positive_angle(mrpt::math::wrapToPi(to_center + M_PI_2));
    const double right = positive_angle(mrpt::math::wrapToPi(to_center + M_PI - to_goal));
    shortest = std::min(shortest, radius * (left + right));
  }
  return shortest;
}

/// The length of the shortest curve of a car that drives forward only to a position in its frame,
/// in any heading: an arc and a straight line, or two arcs (Boissonnat and Bui 1994, "Accessibility
/// region for a car that only moves forwards along optimal paths").
double shortest_curve(const TPoint2D& goal, double radius) {
  constexpr double kRounding = 1e-9;  // m
  double shortest = HUGE_VAL;
  for (const double side : {1.0, -1.0}) {
    const TPoint2D from_center(goal.x, side * goal.y - radius);
    if (from_center.norm() < radius - kRounding) continue;
    shortest =
        std::min({shortest, arc_and_line(from_center, radius), arc_and_arc(from_center, radius)});
  }
  return shortest;
}

}  // namespace

double obstacle_free_bound(const PlanningProblem& problem, double min_turning_radius,
                           bool reversible) {
  const Car car{problem.start_heading, min_turning_radius, reversible};
  const TPoint2D to_goal = problem.goal - problem.start;
  double bound = distance_between(problem.goal, problem.start);
  constexpr int kBearings = 3600;  // each gives a bound
  for (int i = 0; i < kBearings; ++i) {
    const double direction = 2 * M_PI * i / kBearings;
    const double progress = to_goal.x * math::cos(direction) + to_goal.y * math::sin(direction);
    const double turn = car.turn_to(direction);
    // A path that proceeds as far has turned completely: it is longer than the turn.
    if (progress <= min_turning_radius * math::sin(turn)) continue;
    bound = std::max(bound, progress + min_turning_radius * (turn - math::sin(turn)));
  }
  if (reversible) return bound;
  const double c = math::cos(problem.start_heading), s = math::sin(problem.start_heading);
  const TPoint2D in_frame(c * to_goal.x + s * to_goal.y, c * to_goal.y - s * to_goal.x);
  return std::max(bound, shortest_curve(in_frame, min_turning_radius));
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
