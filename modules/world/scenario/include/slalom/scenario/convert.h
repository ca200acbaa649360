// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

namespace slalom {

/// Options of conversions between representations; lengths in m.
struct ConversionOptions {
  double resolution = 0.05;  ///< cells of grids, spacing of points on boundaries
  double tolerance = 0;      ///< of simplified outlines of cells, see trace_contours()
  double point_radius = 0;   ///< of the discs made from points; 0: half the resolution
};

/// `scenario` in another representation (same name, start, goal, movers); unchanged if it has that
/// representation already. The obstacles are converted as follows:
/// - primitives to a grid: the cells that they touch; points to a grid: the cells that contain
///   them;
/// - primitives to points: points on their boundaries, spaced by at most the resolution;
/// - a grid to points: centers of the occupied cells that have a free 4-neighbor;
/// - a grid to primitives: polygons around its cells, within the tolerance (see trace_contours());
/// - points to primitives: discs of point_radius.
/// Throws Error (Usage) when a length is out of range or more than 400 million cells or 100 million
/// points would result.
Scenario convert(const Scenario& scenario, Representation to, const ConversionOptions& options);

}  // namespace slalom
