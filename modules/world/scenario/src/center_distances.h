// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace slalom {

/// The distances (m) from the cell centers of a grid to the nearest occupied closed square or the
/// border, row-major, from the numbers of cells to the nearest occupied one of the row on both
/// sides. Returns false, with incomplete results, if one is 128 cells or more.
bool fill_center_distances(const std::uint16_t* to_left, const std::uint16_t* to_right, int size_x,
                           int size_y, double resolution, float* distances);

}  // namespace slalom
