// SPDX-License-Identifier: BSD-3-Clause
#include "along_path.h"

#include <slalom/core/math.h>
#include <slalom/descriptors/descriptor.h>

#include <algorithm>
#include <cmath>

namespace slalom::descriptors {

/// Fraction of P* with a free line of sight to the goal at any distance, at the midpoints of
/// segments of at most a quarter of a cell.
Value goal_visibility(const DescriptorContext& context) {
  constexpr double kSegmentLength = 0.25;  // cells
  const KnownPath& shortest = context.shortest();
  if (shortest.path.empty()) return Value::na(shortest.reason);
  if (!(shortest.length > 0)) return Value::na("start and goal coincide");
  const RayCaster& rays = context.world.ray_caster();
  const mrpt::math::TPoint2D goal = context.world.scenario().goal();
  const auto points =
      segment_midpoints(shortest.path, kSegmentLength * context.world.occupancy().resolution());
  const auto sees_goal = [&](const mrpt::math::TPoint2D& point) {
    const double away = (goal - point).norm();
    const double angle = math::atan2(goal.y - point.y, goal.x - point.x);
    return rays.cast(point, angle, away) >= away * (1 - 1e-9);
  };
  return Value::of(static_cast<double>(std::count_if(points.begin(), points.end(), sees_goal)) /
                   static_cast<double>(points.size()));
}

}  // namespace slalom::descriptors
