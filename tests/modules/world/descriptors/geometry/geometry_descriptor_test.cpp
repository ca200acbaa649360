// SPDX-License-Identifier: BSD-3-Clause
// Descriptors of the obstacles alone, in worlds with 1 m cells.
#include "../small_worlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace slalom {
namespace {

TEST(Density, IsTheFractionOfOccupiedCells) {
  const World world = drawn_world({".....", ".#.#.", "S...G", ".#...", "....#"});
  EXPECT_DOUBLE_EQ(value_of("density", context_of(world)), 4.0 / 25);
}

TEST(ObstacleCount, CountsComponentsAwayFromTheBorder) {
  EXPECT_DOUBLE_EQ(value_of("obstacle_count", context_of(drawn_world(kBlocks))), 3);
  EXPECT_DOUBLE_EQ(value_of("obstacle_count", context_of(drawn_world(kEmpty))), 0);
}

TEST(ObstacleCount, CellsThatShareACornerAreOneComponent) {
  const World pair = drawn_world({".....", ".#...", "S.#.G", ".....", "....."});
  EXPECT_DOUBLE_EQ(value_of("obstacle_count", context_of(pair)), 1);
  const World chain = drawn_world({"#....", ".#...", "S.#.G", ".....", "....."});
  EXPECT_DOUBLE_EQ(value_of("obstacle_count", context_of(chain)), 0) << "it touches the border";
}

/// Counts components by filling each one from one of its cells.
int components_by_filling(const Occupancy& cells) {
  std::vector<std::uint8_t> left = cells.cells();
  int count = 0;
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x) {
      if (left[cells.index(x, y)] == 0) continue;
      std::vector<std::pair<int, int>> open = {{x, y}};
      bool touches_border = false;
      while (!open.empty()) {
        const auto [cx, cy] = open.back();
        open.pop_back();
        if (!cells.inside(cx, cy)) touches_border = true;
        if (!cells.inside(cx, cy) || left[cells.index(cx, cy)] == 0) continue;
        left[cells.index(cx, cy)] = 0;
        for (int i = 0; i < 9; ++i) open.emplace_back(cx + i % 3 - 1, cy + i / 3 - 1);
      }
      if (!touches_border) ++count;
    }
  return count;
}

TEST(ObstacleCount, EqualsFillingInRandomWorlds) {
  RandomEngine random(3);
  int found = 0;
  for (int repetition = 0; repetition < 300; ++repetition) {
    const double fraction = uniform_real(random, 0, 0.5);
    std::vector<std::string> rows(static_cast<std::size_t>(uniform_int(random, 1, 30)));
    const int width = uniform_int(random, 2, 40);
    for (std::string& row : rows)
      for (int x = 0; x < width; ++x) row += uniform_real(random, 0, 1) < fraction ? '#' : '.';
    const World world = drawn_world(rows);
    const int expected = components_by_filling(world.occupancy());
    EXPECT_EQ(value_of("obstacle_count", context_of(world)), expected) << "world " << repetition;
    found += expected;
  }
  EXPECT_GT(found, 1000);
}

TEST(Clustering, IsVarianceOverMeanInGrains) {
  // 25 quadrats of one cell, 4 of them occupied: mean 0.16, variance (4 - 25 x 0.16^2) / 24 = 0.14.
  // The perimeter has 16 sides, pi / 4 of which is 4 pi: grains of radius 2 x 4 / (4 pi), area 4 /
  // pi.
  EXPECT_NEAR(value_of("clustering", context_of(drawn_world(kBlocks))), 0.14 / 0.16 / (4 / M_PI),
              1e-12);
  EXPECT_EQ(descriptor("clustering").compute(context_of(drawn_world(kEmpty))).reason(),
            "no obstacles");
}

TEST(OccupancyEntropy, IsTheMeanEntropyOfBlocks) {
  // Blocks of 2 x 2 cells from the lower left corner, clipped in the last column and row. A block
  // with 1 of 4 cells occupied has h(1/4) bit; there are three. In the lower right corner 1 of 2:
  // 1 bit. All others have none.
  const double quarter = 0.25 * 2 - 0.75 * std::log2(0.75);
  EXPECT_NEAR(value_of("occupancy_entropy", context_of(drawn_world(kBlocks))),
              (3 * 4 * quarter + 2 * 1) / 25, 1e-12);
  EXPECT_DOUBLE_EQ(value_of("occupancy_entropy", context_of(drawn_world(kEmpty))), 0);
}

TEST(DynamicDensity, IsZeroWhereNothingMoves) {
  EXPECT_DOUBLE_EQ(value_of("dynamic_density", context_of(drawn_world(kBlocks))), 0);
}

TEST(DynamicDensity, IsTheAreaOfTheMoversPerAreaOfTheWorkspace) {
  // Discs of 0.3 m and 0.4 m in 5 m x 8 m.
  const Movers movers{{"a", 0.3, {{0, {1, 1}}, {5, {4, 1}}}, MoverEnd::Stop},
                      {"b", 0.4, {{3, {2, 2}}}, MoverEnd::Vanish}};
  const World world(
      Scenario::continuous("moving", {0, 0, 5, 8}, {}, {1, 4, 0}, {4, 4}).with_movers(movers), 0.1);
  EXPECT_NEAR(value_of("dynamic_density", context_of(world)), M_PI * (0.09 + 0.16) / 40, 1e-15);
}

}  // namespace
}  // namespace slalom
