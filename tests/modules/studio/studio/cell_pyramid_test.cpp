// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/studio/scene.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// 600 x 300 cells of 0.1 m with the lower left corner at (-5, 2); cell (2, 1) is 255.
CellPyramid one_cell(CellPyramid::Merge merge) {
  const Occupancy cells(600, 300, 0.1, {-5, 2});
  std::vector<std::uint8_t> values(cells.cells().size(), 0);
  values[cells.index(2, 1)] = 255;
  return {cells, values, merge};
}

TEST(CellPyramid, HalvesUntilOneTileSuffices) {
  // 600, 300, 150: 150 is at most 256. Rows: 300, 150, 75.
  const CellPyramid pyramid = one_cell(CellPyramid::Merge::Mean);
  ASSERT_EQ(pyramid.levels(), 3);
  EXPECT_EQ(pyramid.size_x(1), 300);
  EXPECT_EQ(pyramid.size_x(2), 150);
  EXPECT_EQ(pyramid.size_y(2), 75);
}

TEST(CellPyramid, KeepsAnOddLastRowAndColumn) {
  const Occupancy cells(301, 1, 1, {0, 0});
  std::vector<std::uint8_t> values(301, 0);
  values[300] = 200;
  const CellPyramid pyramid(cells, values, CellPyramid::Merge::Mean);
  ASSERT_EQ(pyramid.size_x(1), 151);
  EXPECT_EQ(pyramid.size_y(1), 1);
  EXPECT_EQ(pyramid.value(1, 150, 0), 200);
}

TEST(CellPyramid, MergesByMeanOrEmphasizesMaxima) {
  // Mean of (255, 0, 0, 0) is 63.75, rounded 64; half of that and half of 255 is 159.5.
  EXPECT_EQ(one_cell(CellPyramid::Merge::Mean).value(1, 1, 0), 64);
  EXPECT_EQ(one_cell(CellPyramid::Merge::Emphasize).value(1, 1, 0), 160);
  EXPECT_EQ(one_cell(CellPyramid::Merge::Emphasize).value(1, 2, 0), 0);
}

TEST(CellPyramid, ChoosesTheFinestLevelWithCellsOfAtLeastAPixel) {
  const CellPyramid pyramid = one_cell(CellPyramid::Merge::Mean);
  EXPECT_EQ(pyramid.level_for(1000), 0);  // a cell is 100 pixels
  EXPECT_EQ(pyramid.level_for(10), 0);    // 1 pixel
  EXPECT_EQ(pyramid.level_for(9.9), 1);   // 0.99 pixels, doubled 1.98
  EXPECT_EQ(pyramid.level_for(5), 1);     // doubled exactly 1
  EXPECT_EQ(pyramid.level_for(4.9), 2);
  EXPECT_EQ(pyramid.level_for(0.1), 2);  // the coarsest level
}

TEST(CellPyramid, ReturnsTheVisibleTiles) {
  // Tiles of level 0 are 25.6 m: three in a row (from -5, 20.6 and 46.2), two rows (2 and 27.6).
  const CellPyramid pyramid = one_cell(CellPyramid::Merge::Mean);
  const auto tiles = pyramid.tiles_in(0, {0, 0, 21, 10});
  ASSERT_EQ(tiles.size(), 2U);
  EXPECT_TRUE(tiles[0] == (CellTile{0, 0, 0}));
  EXPECT_TRUE(tiles[1] == (CellTile{0, 1, 0}));
  EXPECT_EQ(pyramid.tiles_in(0, {-1e9, -1e9, 1e9, 1e9}).size(), 6U);
  EXPECT_EQ(pyramid.tiles_in(2, {-1e9, -1e9, 1e9, 1e9}).size(), 1U);
  EXPECT_TRUE(pyramid.tiles_in(0, {100, 0, 110, 10}).empty());
  EXPECT_TRUE(pyramid.tiles_in(0, {-20, 0, -10, 10}).empty());
}

TEST(CellPyramid, CutsTilesAtTheEndOfTheGrid) {
  const CellPyramid pyramid = one_cell(CellPyramid::Merge::Mean);
  const CellTile corner{0, 2, 1};
  EXPECT_EQ(pyramid.tile_size_x(corner), 600 - 512);
  EXPECT_EQ(pyramid.tile_size_y(corner), 300 - 256);
  const Bounds bounds = pyramid.bounds_of(corner);
  EXPECT_NEAR(bounds.x_min, -5 + 51.2, 1e-9);
  EXPECT_NEAR(bounds.y_min, 2 + 25.6, 1e-9);
  EXPECT_NEAR(bounds.x_max, 55, 1e-9);
  EXPECT_NEAR(bounds.y_max, 32, 1e-9);
}

}  // namespace
}  // namespace slalom
