#pragma once

#include <slalom/scenario/occupancy.h>

#include <vector>

namespace slalom {

/// The obstacles of a grid lie this far within their cells (in cells): a polygon that touches a
/// cell occupies it, so that one on the very border would take the free neighbour too.
constexpr double kContourInset = 1e-4;

/// The occupied cells as simple polygons (counter-clockwise, m), found by tracing the outlines of
/// 4-connected components. A component with holes is cut along rows, so that no part has one; the
/// parts overlap at the cuts, and no slit opens there.
///
/// With tolerance 0 the polygons are the cells, less kContourInset of a cell next to free cells:
/// make_occupancy() of them at the same resolution gives the same cells. With a tolerance (m) above
/// that inset outlines have fewer vertices, and lie nowhere further than `tolerance` from the
/// cells' own (Hausdorff distance, of outlines and of the areas; Douglas and Peucker 1973). Throws
/// Error (Usage) when tolerance is negative or no number.
std::vector<Polygon> trace_contours(const Occupancy& cells, double tolerance = 0);

}  // namespace slalom
