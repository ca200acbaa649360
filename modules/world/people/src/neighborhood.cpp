// SPDX-License-Identifier: BSD-3-Clause
#include "vectors.h"

#include <slalom/people/neighborhood.h>

#include <algorithm>
#include <tuple>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The velocities at which a disc comes at most `gap` closer to what lies at `offset`, at
/// `distance`, within `duration`. A gap below 0 is one of 0: not further in.
VelocityBound approach_bound(const TPoint2D& offset, double distance, double gap, double duration) {
  return {offset * (-1 / distance), std::min(0.0, -gap / duration)};
}

}  // namespace

void sort_by_place(Neighborhood& around, PeopleSide side) {
  const double sign = side == PeopleSide::Left ? 1 : -1;
  const auto place = [&](const TPoint2D& offset, int rank) {
    return std::make_tuple(dot(offset, offset), dot(offset, around.wanted),
                           sign * cross(offset, around.wanted), rank);
  };
  std::sort(around.neighbors.begin(), around.neighbors.end(),
            [&](const Neighbor& a, const Neighbor& b) {
              return place(a.disc.position - around.self.position, a.rank) <
                     place(b.disc.position - around.self.position, b.rank);
            });
  std::sort(around.walls.begin(), around.walls.end(), [&](const WallPoint& a, const WallPoint& b) {
    return place(a.offset, int{a.faces_person}) < place(b.offset, int{b.faces_person});
  });
}

std::vector<VelocityBound> hard_bounds(const Neighborhood& around, const PeopleSettings& settings) {
  std::vector<VelocityBound> bounds;
  bounds.reserve(around.walls.size() + 2 * around.neighbors.size());
  const CrowdDisc& self = around.self;
  const double wall_reach = self.radius + around.max_speed * settings.wall_horizon;
  for (const WallPoint& wall : around.walls) {
    const double distance = norm(wall.offset);
    if (distance > 0 && distance < wall_reach)
      bounds.push_back(
          approach_bound(wall.offset, distance, distance - self.radius, settings.wall_horizon));
  }
  const double duration = 2 * settings.period;  // each of the two may use up half of the gap
  for (const Neighbor& neighbor : around.neighbors) {
    if (!neighbor.keeps_apart) continue;
    const TPoint2D offset = neighbor.disc.position - self.position;
    const double distance = norm(offset), gap = distance - self.radius - neighbor.disc.radius;
    if (gap >= around.max_speed * duration) continue;
    if (distance > 0)
      bounds.push_back(approach_bound(offset, distance, gap, duration));
    else
      bounds.push_back({{around.rank < neighbor.rank ? 1.0 : -1.0, 0}, 0});
  }
  return bounds;
}

}  // namespace slalom
