#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <string>

namespace slalom {

/// A grid turned by `yaw` (rad, counter-clockwise) about its lower left corner, on cells of the
/// same size along the axes of the world. Each new cell takes the smallest probability of being
/// free among the old cells that it overlaps, and counts what lies beyond the old grid as unknown:
/// no obstacle gets lost or smaller; it grows by less than the diagonal of a cell. Quarter turns
/// are exact. Throws Error (File) naming `where` when more than 400 million cells would result.
mrpt::maps::COccupancyGridMap2D turned_grid(const mrpt::maps::COccupancyGridMap2D& grid, double yaw,
                                            const std::string& where);

}  // namespace slalom
