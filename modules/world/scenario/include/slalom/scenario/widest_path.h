// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/world.h>

namespace slalom {

/// The largest bottleneck (m) of all paths from start to goal: max over paths of the min over the
/// path of d. Searched on 8-connected cell centers (diagonal steps only between free side cells),
/// with the clearance of start and goal at their exact positions. 0 when no path exists.
double widest_bottleneck(const World& world, const mrpt::math::TPoint2D& start,
                         const mrpt::math::TPoint2D& goal);

/// Whether widest_bottleneck() is at least `width` (m, above 0). Much faster where it is: the
/// search goes towards the goal and ends there.
bool has_bottleneck(const World& world, const mrpt::math::TPoint2D& start,
                    const mrpt::math::TPoint2D& goal, double width);

}  // namespace slalom
