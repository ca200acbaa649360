// SPDX-License-Identifier: BSD-3-Clause
#include "random_worlds.h"

#include <slalom/scenario/grid_map.h>
#include <slalom/scenario/widest_path.h>

#include <gtest/gtest.h>

#include <functional>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

World grid_world(const Occupancy& cells) {
  auto map = make_grid_map(cells.size_x(), cells.size_y(), cells.resolution(), cells.origin());
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx)
      if (cells.occupied(cx, cy)) map.setCell(cx, cy, 0.0F);
  const TPoint2D corner = cells.cell_center(0, 0);
  return {Scenario::grid("grid", map, {corner.x, corner.y, 0}, corner), 1};
}

/// The largest value at which start and goal are still connected through nodes of at least that
/// value: flood fill for every value that occurs.
double bottleneck_by_flooding(const World& world, const TPoint2D& start, const TPoint2D& goal) {
  const Occupancy& cells = world.occupancy();
  const auto cell_of = [&](const TPoint2D& p) {
    const TPoint2D at = cells.to_cells(p);
    return cells.index(static_cast<int>(at.x), static_cast<int>(at.y));
  };
  const std::size_t source = cell_of(start), target = cell_of(goal);
  std::vector<double> value(world.distance_field().centers().begin(),
                            world.distance_field().centers().end());
  value[source] = world.distance_field().clearance(start);
  value[target] = world.distance_field().clearance(goal);
  if (source == target)
    value[source] = std::min(world.distance_field().clearance(start), value[target]);
  double best = 0;
  for (const double level : value) {
    if (level <= best) continue;
    std::vector<bool> visited(value.size(), false);
    const std::function<void(int, int)> flood = [&](int x, int y) {
      if (cells.occupied(x, y) || visited[cells.index(x, y)] || value[cells.index(x, y)] < level)
        return;
      visited[cells.index(x, y)] = true;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (!cells.occupied(x + dx, y) && !cells.occupied(x, y + dy)) flood(x + dx, y + dy);
    };
    flood(static_cast<int>(source) % cells.size_x(), static_cast<int>(source) / cells.size_x());
    if (visited[target]) best = level;
  }
  return best;
}

TEST(WidestPath, AgreesWithFloodFillAtEveryWidth) {
  RandomEngine random(13);
  int connected = 0;
  for (int n = 0; n < 300; ++n) {
    const World world = grid_world(testing::random_occupancy(random, 14));
    for (int i = 0; i < 5; ++i) {
      const TPoint2D start = testing::random_point(random, world.occupancy().bounds());
      const TPoint2D goal = testing::random_point(random, world.occupancy().bounds());
      const double expected = bottleneck_by_flooding(world, start, goal);
      ASSERT_EQ(widest_bottleneck(world, start, goal), expected);
      connected += expected > 0;
    }
  }
  EXPECT_GT(connected, 300);
}

TEST(WidestPath, FindsTheDoorInAWall) {
  // Two rooms of 2 m x 2 m and a wall with a door of 0.6 m: 0.3 m to either side at its center
  // line.
  const Primitives wall{
      {}, {{{{2, 0}, {2.1, 0}, {2.1, 0.7}, {2, 0.7}}}, {{{2, 1.3}, {2.1, 1.3}, {2.1, 2}, {2, 2}}}}};
  const TPoint2D goal(3, 1);
  const World world(Scenario::continuous("rooms", {0, 0, 4, 2}, wall, {1, 1, 0}, goal), 0.02);
  EXPECT_NEAR(widest_bottleneck(world, {1, 1}, goal), 0.3, 0.04);
  EXPECT_LE(widest_bottleneck(world, {1, 1}, goal), 0.3 + 1e-6);
}

TEST(WidestPath, IsZeroWithoutAPath) {
  const Primitives wall{{}, {{{{2, 0}, {2.1, 0}, {2.1, 2}, {2, 2}}}}};
  const TPoint2D goal(3, 1);
  const World world(Scenario::continuous("closed", {0, 0, 4, 2}, wall, {1, 1, 0}, goal), 0.05);
  EXPECT_EQ(widest_bottleneck(world, {1, 1}, goal), 0);
  EXPECT_EQ(widest_bottleneck(world, {2.05, 1}, goal), 0) << "start in the wall";
  EXPECT_GT(widest_bottleneck(world, {3.5, 1}, goal), 0);
}

}  // namespace
}  // namespace slalom
