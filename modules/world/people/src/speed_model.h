// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/people/neighborhood.h>

namespace slalom {

/// m: the repulsion of walls and neighbors is ignored from this gap on.
constexpr double kRepulsionReach = 1;

/// The velocity by the collision-free speed model (Tordeux, Chraibi and Seyfried 2015): the wanted
/// direction, repelled by neighbors and walls; the speed at which a time gap remains to the nearest
/// neighbor ahead. In a single file of density rho the speed is (1 / rho - 2 radius) / time gap.
/// Requires neighbors and walls that are sorted by place.
mrpt::math::TPoint2D speed_velocity(const Neighborhood& around, const PeopleSettings& settings);

}  // namespace slalom
