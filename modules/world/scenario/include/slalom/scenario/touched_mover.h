// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/world.h>

#include <mrpt/math/TPoint2D.h>

#include <vector>

namespace slalom {

/// Finds the obstacle that a robot touches in a collision at time t (s): the nearest of `movers`
/// that is present, or null if a static obstacle is nearer than all movers and none touches the
/// robot. The robot is the polygon with these corners (m, world frame) or, without any, a disc of
/// `radius` (m) around `center`. All callers share this function: between a wall and a mover, or
/// between two movers, the last bit decides.
const Mover* touched_mover(const World& world, const Movers& movers,
                           const mrpt::math::TPoint2D& center, double radius,
                           const std::vector<mrpt::math::TPoint2D>& corners, double t);

}  // namespace slalom
