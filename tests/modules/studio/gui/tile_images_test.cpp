// SPDX-License-Identifier: BSD-3-Clause
#include "views/scene_layers.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

const Color kWhite(255, 255, 255, 255), kBlack(0, 0, 0, 255), kRed(255, 0, 0, 255),
    kClear(255, 0, 0, 0);

std::shared_ptr<const CellPyramid> pyramid_of(std::vector<std::uint8_t> values) {
  const Occupancy cells(2, 2, 1, {0, 0});
  return std::make_shared<CellPyramid>(cells, std::move(values), CellPyramid::Merge::Mean);
}

TEST(TileImages, InterpolateColorsOfAScale) {
  const ColorScalePtr scale = make_color_scale(kWhite, kBlack);
  EXPECT_EQ((*scale)[0][0], 255);
  EXPECT_EQ((*scale)[255][0], 0);
  EXPECT_EQ((*scale)[51][0], 204);  // 20 %
}

TEST(TileImages, ComposeLayersFromTheBottomRow) {
  // Rows from the bottom: free, occupied; occupied, free. Red on the first cell of the upper row.
  const std::vector<ColoredCells> layers = {
      {pyramid_of({0, 255, 255, 0}), make_color_scale(kWhite, kBlack)},
      {pyramid_of({0, 0, 255, 0}), make_color_scale(kClear, kRed)}};
  const auto pixels = compose_tile(layers, {0, 0, 0}, Color(9, 9, 9, 255));
  const std::vector<std::uint8_t> expected = {255, 255, 255, 255, 0,   0,   0,   255,
                                              255, 0,   0,   255, 255, 255, 255, 255};
  EXPECT_EQ(pixels, expected);
}

TEST(TileImages, ShowTheBackgroundThroughTransparentCells) {
  const auto pixels = compose_tile({{pyramid_of({0, 0, 0, 255}), make_color_scale(kClear, kRed)}},
                                   {0, 0, 0}, Color(9, 8, 7, 255));
  EXPECT_EQ(std::vector<std::uint8_t>(pixels.begin(), pixels.begin() + 4),
            (std::vector<std::uint8_t>{9, 8, 7, 255}));
  EXPECT_EQ(pixels[12], 255);
}

/// 600 x 300 cells of 0.1 m from (0, 0) on 100 x 100 pixels.
TileClip clip(const CellTile& tile, double x, double y, double scale, double ratio = 1) {
  const Occupancy cells(600, 300, 0.1, {0, 0});
  const CellPyramid pyramid(cells, std::vector<std::uint8_t>(cells.cells().size(), 0),
                            CellPyramid::Merge::Mean);
  return clip_tile(pyramid, tile, ViewTransform({x, y}, scale, {0, 0, 100, 100}), ratio);
}

TEST(TileClip, HasTheVisibleCellsOnIntegerPixels) {
  // 100 pixels per meter: 1 m is visible around (5.03, 4), from x = 4.53 and y = 3.5: cells 45
  // (begins at 4.5, 3 pixels before) to 55 (ends at 5.6) and 35 to 44.
  const TileClip visible = clip({0, 0, 0}, 5.03, 4, 100);
  EXPECT_EQ(visible.cell_left, 45);
  EXPECT_EQ(visible.cell_right, 56);
  EXPECT_EQ(visible.left, -3);
  EXPECT_EQ(visible.right, 107);
  EXPECT_LE(visible.cell_low, 35);
  EXPECT_GE(visible.cell_high, 45);
  EXPECT_EQ(visible.bottom - visible.top, 10 * (visible.cell_high - visible.cell_low));
}

TEST(TileClip, OfAdjacentTilesSharesTheirBorder) {
  for (const double scale : {3.7, 11.3, 61.9}) {
    const TileClip left = clip({0, 0, 0}, 25.6, 3, scale), right = clip({0, 1, 0}, 25.6, 3, scale);
    EXPECT_EQ(left.right, right.left) << scale;
    EXPECT_EQ(left.cell_right, CellPyramid::kTileSize);
    EXPECT_EQ(right.cell_left, 0);
  }
}

TEST(TileClip, CountsFramebufferPixels) {
  const TileClip coarse = clip({0, 0, 0}, 5, 4, 100), fine = clip({0, 0, 0}, 5, 4, 100, 2);
  EXPECT_EQ(fine.left, 2 * coarse.left);
  EXPECT_EQ(fine.bottom, 2 * coarse.bottom);
}

TEST(TileClip, IsEmptyOutsideTheView) {
  const TileClip none = clip({0, 1, 0}, 5, 4, 100);
  EXPECT_EQ(none.cell_left, none.cell_right);
  EXPECT_EQ(none.left, none.right);
}

}  // namespace
}  // namespace slalom
