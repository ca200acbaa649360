// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/generation/start_goal.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr int kMaxPairs = 1000, kMaxPositions = 200;

std::optional<TPoint2D> sample_valid_position(RandomEngine& engine, const Bounds& bounds,
                                              double margin, const PositionFilter& is_valid) {
  for (int i = 0; i < kMaxPositions; ++i) {
    const TPoint2D position = sample_position(engine, bounds, margin);
    if (!is_valid || is_valid(position)) return position;
  }
  return std::nullopt;
}

}  // namespace

TPoint2D sample_position(RandomEngine& engine, const Bounds& bounds, double margin) {
  const double x = uniform_real(engine, bounds.x_min + margin, bounds.x_max - margin);
  return {x, uniform_real(engine, bounds.y_min + margin, bounds.y_max - margin)};
}

StartGoal sample_start_goal(RandomEngine& engine, const Bounds& bounds,
                            const StartGoalOptions& options, const PositionFilter& is_valid) {
  return sample_start_goal(engine, bounds, bounds, options, is_valid);
}

StartGoal sample_start_goal(RandomEngine& engine, const Bounds& starts, const Bounds& goals,
                            const StartGoalOptions& options, const PositionFilter& is_valid) {
  const double m = options.margin;
  for (int i = 0; i < kMaxPairs; ++i) {
    const auto start = sample_valid_position(engine, starts, m, is_valid);
    if (!start) break;
    const auto goal = sample_valid_position(engine, goals, m, is_valid);
    if (!goal) break;
    if (distance_between(*goal, *start) >= options.min_distance) return {*start, *goal};
  }
  return {{starts.x_min + m, starts.y_min + m}, {goals.x_max - m, goals.y_max - m}};
}

PositionFilter clearance_filter(const Primitives& obstacles, double radius) {
  return [&obstacles, radius](const TPoint2D& position) {
    const auto has_clearance = [&](const auto& o) { return distance(position, o) >= radius; };
    return std::all_of(obstacles.discs.begin(), obstacles.discs.end(), has_clearance) &&
           std::all_of(obstacles.polygons.begin(), obstacles.polygons.end(), has_clearance);
  };
}

PositionFilter clearance_filter(const DistanceField& field, double radius) {
  return [&field, radius](const TPoint2D& position) { return field.clearance(position) >= radius; };
}

mrpt::math::TPose2D start_pose(RandomEngine& engine, const StartGoal& start_goal) {
  const double bearing =
      math::atan2(start_goal.goal.y - start_goal.start.y, start_goal.goal.x - start_goal.start.x);
  const double heading = bearing + uniform_real(engine, -M_PI / 4, M_PI / 4);
  return {start_goal.start.x, start_goal.start.y, wrap_angle(heading)};
}

double wrap_angle(double angle) {
  if (angle > M_PI) return angle - 2 * M_PI;
  if (angle <= -M_PI) return angle + 2 * M_PI;
  return angle;
}

void StartGoalOptions::visit(OptionVisitor& v) {
  v.option("clear_radius", clear_radius, "m", "clearance around start and goal",
           Range::at_least(0));
  v.option("min_distance", min_distance, "m", "straight-line distance from start to goal",
           Range::at_least(0));
  v.option("margin", margin, "m", "distance of start and goal from the workspace border",
           Range::at_least(0));
}

}  // namespace slalom
