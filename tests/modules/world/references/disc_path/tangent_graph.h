// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/occupancy.h>

namespace slalom {

/// Whether the segment a-b is at least `radius` away from every occupied square, those around the
/// grid included, each tested by itself. In cells.
bool is_far_from_occupied(const Occupancy& cells, const mrpt::math::TPoint2D& a,
                          const mrpt::math::TPoint2D& b, double radius);

/// Length (cells) of the shortest path of a disc by brute force, as a reference for tests: all
/// tangents of the circles about all convex corners, each tested against every occupied square,
/// and Dijkstra's algorithm. Infinite if there is none. Positions and radius in cells.
double tangent_graph_length(const Occupancy& cells, double radius,
                            const mrpt::math::TPoint2D& start, const mrpt::math::TPoint2D& goal);

}  // namespace slalom
