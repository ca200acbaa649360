// SPDX-License-Identifier: BSD-3-Clause
#include "free_rectangles.h"
#include "random_worlds.h"
#include "rectangle_codes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace slalom {
namespace {

/// One plane, without the border that RayCaster adds.
std::vector<std::uint8_t> rectangles_of(const Occupancy& cells, bool left, bool down) {
  std::vector<std::uint8_t> rectangles(cells.cells().size(), 255);
  fill_free_rectangles(cells.cells().data(), cells.size_x(), cells.size_y(), left, down,
                       cells.size_x(), rectangles.data());
  return rectangles;
}

/// The occupancy as a ray to the left or downwards sees it.
Occupancy mirror(const Occupancy& cells, bool left, bool down) {
  Occupancy mirrored(cells.size_x(), cells.size_y(), 1, {0, 0});
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x)
      mirrored.set_occupied(
          x, y,
          cells.occupied(left ? cells.size_x() - 1 - x : x, down ? cells.size_y() - 1 - y : y));
  return mirrored;
}

bool is_free(const Occupancy& cells, int x, int y, int width, int height) {
  for (int dy = 0; dy < height; ++dy)
    for (int dx = 0; dx < width; ++dx)
      if (cells.occupied(x + dx, y + dy)) return false;
  return true;
}

TEST(FreeRectangles, AreFreeAndNotTheBestThatCouldBeExtended) {
  RandomEngine random(31);
  for (int n = 0; n < 20; ++n) {
    const Occupancy cells = testing::random_occupancy(random, 150);
    for (const bool left : {false, true})
      for (const bool down : {false, true}) {
        const Occupancy seen = mirror(cells, left, down);
        const std::vector<std::uint8_t> rectangles = rectangles_of(cells, left, down);
        for (int y = 0; y < cells.size_y(); ++y)
          for (int x = 0; x < cells.size_x(); ++x) {
            const std::uint8_t codes = rectangles[cells.index(x, y)];
            const std::size_t width = codes & 15U, height = codes >> 4U;
            ASSERT_EQ(codes == 0, seen.occupied(x, y)) << x << ' ' << y;
            ASSERT_EQ(width == 0, height == 0);
            ASSERT_TRUE(is_free(seen, x, y, kExtents[width], kExtents[height]));
            if (codes == 0 || width + 1 == kExtents.size() || height + 1 == kExtents.size())
              continue;
            ASSERT_FALSE(is_free(seen, x, y, kExtents[width + 1], kExtents[height + 1]))
                << "the next larger one in both directions is better";
          }
      }
  }
}

TEST(FreeRectangles, AreSquaresInOpenSpaceAndLongInCorridors) {
  const Occupancy open(500, 400, 1, {0, 0});
  EXPECT_EQ(rectangles_of(open, false, false)[open.index(0, 0)], 0xFF) << "192 by 192 cells";
  const Occupancy corridor(500, 3, 1, {0, 0});
  EXPECT_EQ(rectangles_of(corridor, true, false)[corridor.index(0, 0)], 0x3F) << "192 by 3";
  const Occupancy shaft(1, 70, 1, {0, 0});
  const std::uint8_t codes = rectangles_of(shaft, false, true)[shaft.index(0, 0)];
  EXPECT_EQ(codes & 15, 1);
  EXPECT_GE(kExtents[codes >> 4U], 12) << "hardly any ray goes further up";
}

TEST(FreeRectangles, HaveExtentsThatDoublingReaches) {
  ASSERT_EQ(kExtents[0], 0);
  ASSERT_EQ(kExtents[1], 1);
  for (std::size_t code = 2; code < kExtents.size(); ++code) {
    EXPECT_GT(kExtents[code], kExtents[code - 1]);
    EXPECT_LE(kExtents[code], 2 * kExtents[code - 1]);
  }
}

}  // namespace
}  // namespace slalom
