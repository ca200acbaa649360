#include "configuration_cells.h"
#include "reference_worlds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Smallest and largest d over points spread over a closed subcell, its corners and center
/// included.
std::pair<double, double> clearances(const World& world, int sx, int sy, double size) {
  const TPoint2D origin = world.occupancy().origin();
  double lowest = 1e9, highest = 0;
  for (const double v : {0.0, 0.25, 0.5, 0.75, 1.0})
    for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const TPoint2D p(origin.x + (sx + u) * size, origin.y + (sy + v) * size);
      const double d = world.distance_field().clearance(p);
      lowest = std::min(lowest, d);
      highest = std::max(highest, d);
    }
  return {lowest, highest};
}

TEST(ConfigurationCells, OuterHasAllFreePointsAndInnerOnlyFreePoints) {
  RandomEngine engine(5);
  for (const int subdivision : {1, 2, 3, 4}) {
    const World world = random_world(engine, 3, 4);
    const double radius = uniform_real(engine, 0.05, 0.4);
    const auto cells = make_configuration_cells(world.occupancy(), radius, subdivision);
    for (int sy = 0; sy < cells.outer.size_y; ++sy)
      for (int sx = 0; sx < cells.outer.size_x; ++sx) {
        const auto [lowest, highest] = clearances(world, sx, sy, cells.cell_size);
        ASSERT_TRUE(!cells.outer.is_blocked(sx, sy) || highest < radius);
        ASSERT_TRUE(cells.inner.is_blocked(sx, sy) || lowest >= radius - 1e-9);
      }
  }
}

TEST(ConfigurationCells, BoundsAreExactNextToAWall) {
  // A square of 20 x 20 cells of 0.05 m, r = 0.12 m = 2.4 cells. Column c spans the distances c to
  // c + 1 from the wall: all closer than 2.4 for c = 0, 1; all at lowest 2.4 from c = 3 on.
  const World world = empty_world(1, {0.5, 0.5}, {0.6, 0.5});
  const auto cells = make_configuration_cells(world.occupancy(), 0.12, 1);
  for (int c = 0; c < 10; ++c) {
    EXPECT_EQ(cells.outer.is_blocked(c, 10), c <= 1) << c;
    EXPECT_EQ(cells.inner.is_blocked(c, 10), c <= 2) << c;
    EXPECT_EQ(cells.outer.is_blocked(10, 19 - c), c <= 1) << c;
    EXPECT_EQ(cells.inner.is_blocked(10, 19 - c), c <= 2) << c;
  }
}

}  // namespace
}  // namespace slalom
