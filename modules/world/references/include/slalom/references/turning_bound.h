// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/references/reference.h>

namespace slalom {

/// A lower bound (m) of the length of every path of a car from the pose of the start to the goal,
/// in any heading there, without obstacles: at least the straight distance. It is the length of the
/// shortest curve of Dubins (1957) to the goal; if the car is `reversible`, that of Reeds and Shepp
/// (1990) where it is an arc of at most 90 degrees and a straight line, and less elsewhere.
double obstacle_free_bound(const PlanningProblem& problem, double min_turning_radius,
                           bool reversible);

/// The same with obstacles: also at least the shortest path of the disc, `exact`, and increased by
/// the turn out of the initial heading.
///
/// Lower bound of the length of a car's path. After a length l the car is in a convex set around
/// its start: it proceeds in the direction at the angle a from its heading by at most the integral
/// of cos(max(0, a - s / radius)) over s from 0 to l. From there the rest is not shorter than the
/// shortest path of the disc. The minimum over that set is bounded by branch and bound over
/// squares; for all positions in a square of circumradius h at once, by the shortest path from its
/// center of a disc smaller by h, less h.
double turning_lower_bound(const PlanningProblem& problem, const ShortestPath& exact,
                           double min_turning_radius, bool reversible);

}  // namespace slalom
