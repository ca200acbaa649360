// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/scenario/grid_map.h>
#include <slalom/scenario/scenario.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

TEST(GridMap, HasExactlyTheRequestedSizeAndOrigin) {
  for (const double resolution : {0.025, 0.05, 0.13, 0.15, 0.7})
    for (int size = 1; size < 200; size += 7) {
      const auto map = make_grid_map(size, 2 * size, resolution, {-4.425, 1000.03});
      ASSERT_EQ(map.getSizeX(), static_cast<unsigned>(size));
      ASSERT_EQ(map.getSizeY(), static_cast<unsigned>(2 * size));
      ASSERT_EQ(map.getXMin(), -4.425F);
      ASSERT_EQ(map.getYMin(), 1000.03F);
      ASSERT_EQ(map.getResolution(), static_cast<float>(resolution));
      ASSERT_FALSE(map.isEmpty());
      ASSERT_GT(map.getCell(size - 1, 2 * size - 1), 0.99F);
    }
}

TEST(GridMap, GivesTheSameScenarioWhenRebuiltFromItsParameters) {
  auto map = make_grid_map(30, 20, 0.15, {-4.425, 5.175});
  map.setCell(3, 4, 0.0F);
  const Scenario first = Scenario::grid("a", map, {-3, 6, 0}, {-2, 7});
  const auto& kept = *first.grid_map();
  auto again = make_grid_map(static_cast<int>(kept.getSizeX()), static_cast<int>(kept.getSizeY()),
                             kept.getResolution(), {kept.getXMin(), kept.getYMin()});
  again.setCell(3, 4, 0.0F);
  EXPECT_EQ(Scenario::grid("b", again, {-3, 6, 0}, {-2, 7}).hash(), first.hash());
}

TEST(GridMap, RefusesImpossibleGrids) {
  EXPECT_THROW(make_grid_map(0, 3, 0.1, {0, 0}), Error);
  EXPECT_THROW(make_grid_map(3, -3, 0.1, {0, 0}), Error);
  EXPECT_THROW(make_grid_map(100000, 100000, 0.1, {0, 0}), Error);
  EXPECT_THROW(make_grid_map(3, 3, 0, {0, 0}), Error);
  EXPECT_THROW(make_grid_map(3, 3, std::nan(""), {0, 0}), Error);
  EXPECT_THROW(make_grid_map(3, 3, 0.1, {HUGE_VAL, 0}), Error);
}

}  // namespace
}  // namespace slalom
