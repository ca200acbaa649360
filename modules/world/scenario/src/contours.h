// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/occupancy.h>

#include <vector>

namespace slalom {

/// Inset (cells) of contours from the borders of their cells: a polygon that touches a cell
/// occupies it, so a polygon exactly on the border would also occupy the free neighbor.
constexpr double kContourInset = 1e-4;

/// The occupied cells as simple polygons (counter-clockwise, m), found by tracing the outlines of
/// 4-connected components. A component with holes is cut along rows into parts without holes. The
/// parts overlap at the cuts, so that no gap opens there.
///
/// With tolerance 0 the polygons are the cells, less kContourInset of a cell next to free cells:
/// make_occupancy() of them at the same resolution gives the same cells. With a tolerance (m) above
/// that inset the outlines have fewer vertices and their Hausdorff distance to those of the cells
/// (of outlines and of areas) is at most `tolerance` (Douglas and Peucker 1973). Throws Error
/// (Usage) when tolerance is negative or not finite.
std::vector<Polygon> trace_contours(const Occupancy& cells, double tolerance = 0);

}  // namespace slalom
