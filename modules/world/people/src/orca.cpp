// SPDX-License-Identifier: BSD-3-Clause
#include "orca.h"
#include "vectors.h"

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The velocities to which the person changes `share` of the least change of the relative velocity
/// v that avoids a disc of `radius` at `offset` within the horizon.
VelocityBound avoidance(const TPoint2D& offset, const TPoint2D& v, const TPoint2D& own,
                        double radius, double share, double horizon) {
  const double distance2 = dot(offset, offset);
  const TPoint2D from_tip = v - offset * (1 / horizon);
  const double length2 = dot(from_tip, from_tip), along = dot(from_tip, offset);
  if (along < 0 && along * along > radius * radius * length2) {  // the round tip of the cone
    const double length = std::sqrt(length2);
    const TPoint2D normal = from_tip * (1 / length);
    return {normal, dot(normal, own) + share * (radius / horizon - length)};
  }
  const double leg = std::sqrt(distance2 - radius * radius);
  TPoint2D normal;
  if (cross(offset, from_tip) > 0)
    normal = left_of({(offset.x * leg - offset.y * radius) / distance2,
                      (offset.x * radius + offset.y * leg) / distance2});
  else
    normal = left_of({(offset.x * leg + offset.y * radius) / distance2,
                      (offset.y * leg - offset.x * radius) / distance2}) *
             -1.0;
  return {normal, dot(normal, own) - share * dot(normal, v)};
}

/// The same for discs that overlap: they part within a period.
VelocityBound parting(const TPoint2D& offset, const TPoint2D& v, const TPoint2D& own, double radius,
                      double share, double period, bool first) {
  const TPoint2D from_center = v - offset * (1 / period);
  const double length = norm(from_center);
  const TPoint2D normal = length > 0 ? from_center * (1 / length) : TPoint2D(first ? 1.0 : -1.0, 0);
  return {normal, dot(normal, own) + share * (radius / period - length)};
}

}  // namespace

TPoint2D orca_velocity(const Neighborhood& around, const PeopleSettings& settings) {
  std::vector<VelocityBound> bounds = hard_bounds(around, settings);
  const std::size_t hard = bounds.size();
  const CrowdDisc& self = around.self;
  int count = 0;
  for (const Neighbor& neighbor : around.neighbors) {
    if (!neighbor.is_visible) continue;
    if (++count > settings.max_neighbors) break;
    const TPoint2D offset = neighbor.disc.position - self.position;
    const TPoint2D v = self.velocity - neighbor.disc.velocity;
    const double radius = self.radius + neighbor.disc.radius + 2 * settings.margin;
    if (dot(offset, offset) > radius * radius)
      bounds.push_back(
          avoidance(offset, v, self.velocity, radius, neighbor.share, settings.horizon));
    else
      bounds.push_back(parting(offset, v, self.velocity, radius, neighbor.share, settings.period,
                               around.rank < neighbor.rank));
  }
  return best_velocity(bounds, hard, around.max_speed, around.wanted);
}

}  // namespace slalom
