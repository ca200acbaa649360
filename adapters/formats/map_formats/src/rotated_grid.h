// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <string>

namespace slalom {

/// Rotates a grid by `yaw` (rad, counter-clockwise) about its lower left corner and resamples it to
/// cells of the same size along the axes of the world. Each new cell gets the minimum probability
/// of being free among the old cells that it overlaps; cells outside the old grid count as unknown.
/// No obstacle is lost or shrinks; it grows by less than the diagonal of a cell. Rotations by
/// multiples of 90 degrees are exact. Throws Error (File) with location `where` if the result has
/// more than 400 million cells.
mrpt::maps::COccupancyGridMap2D rotated_grid(const mrpt::maps::COccupancyGridMap2D& grid,
                                             double yaw, const std::string& where);

}  // namespace slalom
