#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace slalom {

/// Codes of extents (cells) in tables of free rectangles: code i means kExtents[i], and less than
/// the next; 0 is an occupied cell. Each extent but 1 is at most twice an earlier one.
constexpr std::array<std::uint8_t, 16> kExtents = {0,  1,  2,  3,  4,  6,  8,   12,
                                                   16, 24, 32, 48, 64, 96, 128, 192};

/// Fills in, for each cell of a grid, a free rectangle whose lower left cell it is: of those with
/// extents that have codes, the one that rays upwards and to the right leave latest (in the mean of
/// the logarithm). A byte is the code of the width, plus 16 times that of the height. `cells`, row
/// by row, are 0 where free. `left`, `down`: the grid mirrored, for rays to the left or downwards.
/// Row y of the result begins at rectangles + y stride.
void fill_free_rectangles(const std::uint8_t* cells, int size_x, int size_y, bool left, bool down,
                          std::ptrdiff_t stride, std::uint8_t* rectangles);

}  // namespace slalom
