// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/scenario/geometry.h>
#include <slalom/scenario/touched_mover.h>

#include <algorithm>

namespace slalom {

const Mover* touched_mover(const World& world, const Movers& movers,
                           const mrpt::math::TPoint2D& center, double radius,
                           const std::vector<mrpt::math::TPoint2D>& corners, double t) {
  // The simulator ends a motion where the gap to a mover is less than this.
  constexpr double kTouching = 2e-6;  // m
  if (movers.empty()) return nullptr;
  const bool is_disc = corners.empty();
  double nearest = std::max(kTouching, is_disc ? world.distance_field().clearance(center) - radius
                                               : world.distance_field().outline_clearance(corners));
  const Mover* touched = nullptr;
  for (const Mover& mover : movers) {
    if (!mover.present(t)) continue;
    const mrpt::math::TPoint2D position = mover.position(t);
    const double gap = (is_disc ? distance_between(position, center) - radius
                                : distance(position, Polygon{corners})) -
                       mover.radius;
    if (gap >= nearest) continue;
    nearest = gap;
    touched = &mover;
  }
  return touched;
}

}  // namespace slalom
