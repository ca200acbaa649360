#pragma once

#include <slalom/scenario/scenario.h>

namespace slalom {

/// How one representation becomes another; lengths in m.
struct ConversionOptions {
  double resolution = 0.05;  ///< cells of grids, spacing of points on boundaries
  double tolerance = 0;      ///< by which outlines of cells may be simplified (trace_contours())
  double point_radius = 0;   ///< of the discs that points become; 0: half the resolution
};

/// `scenario` in another representation (same name, start, goal); itself where it is in that one
/// already. What the obstacles become:
/// - primitives to a grid: the cells that they touch; points to a grid: the cells that they lie in;
/// - primitives to points: points on their boundaries, no further apart than the resolution;
/// - a grid to points: centres of the occupied cells that have a free 4-neighbour;
/// - a grid to primitives: polygons round its cells, within the tolerance (see trace_contours());
/// - points to primitives: discs of point_radius.
/// Throws Error (Usage) when a length is out of range or more than 400 million cells or 100 million
/// points would result.
Scenario convert(const Scenario& scenario, Representation to, const ConversionOptions& options);

}  // namespace slalom
