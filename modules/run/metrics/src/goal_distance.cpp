// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"

#include <algorithm>
#include <cmath>

namespace slalom::metrics {
namespace {

using mrpt::math::TPoint2D;

double distance_to_goal(const MetricContext& context, const mrpt::math::TPose2D& pose) {
  return length({{pose.x, pose.y}, context.world.scenario().goal()});
}

}  // namespace

/// |p_end - g|.
Value final_distance(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return *na;
  return Value::of(distance_to_goal(context, context.trajectory.samples.back().pose));
}

/// The minimum of |p_i - g|.
Value closest_distance(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return *na;
  double closest = distance_to_goal(context, context.trajectory.samples.front().pose);
  for (const Sample& sample : context.trajectory.samples)
    closest = std::min(closest, distance_to_goal(context, sample.pose));
  return Value::of(closest);
}

/// |phi_end - phi_g| of a run that ends within the tolerance of its goal.
Value goal_heading_error(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return *na;
  const std::optional<double>& heading = context.world.scenario().goal_heading();
  if (!heading) return Value::na("the goal has no heading");
  const auto& end = context.trajectory.samples.back().pose;
  if (distance_to_goal(context, end) > context.goal_tolerance)
    return Value::na("the run does not end at the goal");
  return Value::of(std::abs(std::remainder(end.phi - *heading, 2 * M_PI)));
}

/// 1 - geodesic(p_end, g) / L*: the completed fraction of the path, negative if the remaining path
/// is longer than L*. The geodesic is the exact shortest path of the inscribed disc, as L*.
Value progress(const MetricContext& context) {
  // Maximum penetration (m) at a contact that ends a run; the geodesic is then that of a robot with
  // a radius reduced by it.
  constexpr double kContactDepth = 1e-3;
  if (const auto na = na_without_verdict(context)) return *na;
  if (const auto na = na_without_samples(context)) return *na;
  if (const auto na = na_without_shortest(context)) return *na;
  const auto& end = context.trajectory.samples.back().pose;
  const TPoint2D from(end.x, end.y), goal = context.world.scenario().goal();
  const double robot_radius = context.robot.shape().inscribed_radius();
  const double radius = std::min(robot_radius, context.world.distance_field().clearance(from));
  if (radius < robot_radius - kContactDepth) return Value::na("the run ends inside an obstacle");
  std::string reason;
  const auto rest = geodesic(context, radius, from, goal, reason);
  if (!rest) return Value::na("from the final pose: " + reason);
  return Value::of(1 - *rest / best_length(context));
}

}  // namespace slalom::metrics
