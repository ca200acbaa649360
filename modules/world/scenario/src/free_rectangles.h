// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace slalom {

/// Fills in, for each cell of a grid, a free rectangle whose lower left cell it is: of those with
/// extents that have codes (rectangle_codes.h), the one that rays upwards and to the right leave
/// latest (in the mean of the logarithm). A byte is the code of the width, plus 16 times that of
/// the height. `cells`, row by row, are 0 where free. `left`, `down`: the grid mirrored, for rays
/// to the left or downwards. Row y of the result begins at rectangles + y stride.
void fill_free_rectangles(const std::uint8_t* cells, int size_x, int size_y, bool left, bool down,
                          std::ptrdiff_t stride, std::uint8_t* rectangles);

}  // namespace slalom
