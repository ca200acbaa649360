// SPDX-License-Identifier: BSD-3-Clause
#include "speed_model.h"
#include "vectors.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The repulsion by something in relation to the wanted direction: `strength` where it is touched.
struct Repulsion {
  double strength;
  double decay;  ///< m

  /// Away from what lies at `offset` of the person, whose border is at `radius` of its center.
  TPoint2D from(const TPoint2D& offset, double radius) const {
    const double distance = norm(offset), gap = distance - radius;
    if (distance <= 0 || gap >= 10 * decay) return {0, 0};
    return offset * (-strength * math::exp(-gap / decay) / distance);
  }
};

constexpr Repulsion kOthers{8, 0.1}, kWalls{5, 0.05};
static_assert(10 * kOthers.decay <= kRepulsionReach && 10 * kWalls.decay <= kRepulsionReach);

TPoint2D direction(const Neighborhood& around, const TPoint2D& wanted) {
  constexpr double kNone = 1e-9;
  TPoint2D push(0, 0);
  for (const WallPoint& wall : around.walls)
    if (wall.faces_person) push += kWalls.from(wall.offset, around.self.radius);
  for (const Neighbor& neighbor : around.neighbors)
    if (neighbor.is_visible)
      push += kOthers.from(neighbor.disc.position - around.self.position,
                           around.self.radius + neighbor.disc.radius);
  const TPoint2D sum = wanted + push;
  const double length = norm(sum);
  return length > kNone ? sum * (1 / length) : wanted;
}

/// m, to the nearest neighbor whose disc is met in this direction.
double gap_ahead(const Neighborhood& around, const TPoint2D& direction) {
  double gap = std::numeric_limits<double>::infinity();
  for (const Neighbor& neighbor : around.neighbors) {
    if (!neighbor.is_visible) continue;
    const TPoint2D offset = neighbor.disc.position - around.self.position;
    const double radius = around.self.radius + neighbor.disc.radius;
    if (dot(offset, direction) > 0 && std::abs(cross(direction, offset)) <= radius)
      gap = std::min(gap, norm(offset) - radius);
  }
  return gap;
}

}  // namespace

TPoint2D speed_velocity(const Neighborhood& around, const PeopleSettings& settings) {
  const double speed = norm(around.wanted);
  if (speed <= 0) return {0, 0};
  const TPoint2D ahead = direction(around, around.wanted * (1 / speed));
  const double fitting = gap_ahead(around, ahead) / settings.time_gap;
  const std::vector<VelocityBound> bounds = hard_bounds(around, settings);
  return best_velocity(bounds, bounds.size(), around.max_speed,
                       ahead * std::clamp(fitting, 0.0, speed));
}

}  // namespace slalom
