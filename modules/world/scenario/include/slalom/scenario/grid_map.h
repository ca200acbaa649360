// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/math/TPoint2D.h>

namespace slalom {

/// No grid has more cells.
constexpr double kMaxGridCells = 400e6;

/// An MRPT grid whose content is to be replaced. MRPT's default has 640,000 cells, more than
/// most scenarios.
mrpt::maps::COccupancyGridMap2D one_cell_map();

/// An MRPT grid of exactly size_x x size_y cells, all free, whose lower left corner is at `origin`
/// (m). MRPT's own setSize() moves the origin to a multiple of the resolution (by up to half a
/// cell), which may change the size by one cell. All lengths are rounded to single precision, as in
/// MRPT. Throws Error (Usage) when sizes or resolution are not positive, numbers are not finite, or
/// there are more than 400 million cells.
mrpt::maps::COccupancyGridMap2D make_grid_map(int size_x, int size_y, double resolution,
                                              const mrpt::math::TPoint2D& origin);

/// Makes the cells free that are unknown: exactly 0.5, as MRPT stores them.
void set_unknown_free(mrpt::maps::COccupancyGridMap2D& map);

}  // namespace slalom
