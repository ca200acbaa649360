// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/geometry.h>
#include <slalom/core/random.h>
#include <slalom/people/wall_runs.h>
#include <slalom/scenario/distance_field.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

Occupancy random_cells(RandomEngine& random) {
  Occupancy cells(uniform_int(random, 1, 30), uniform_int(random, 1, 30), 0.25, {-3, 2});
  const double fraction = uniform_real(random, 0, 0.5);
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x)
      cells.set_occupied(x, y, uniform_real(random, 0, 1) < fraction);
  return cells;
}

TEST(WallRuns, AreTheBorderOfTheOccupiedCells) {
  RandomEngine random(3);
  for (int k = 0; k < 50; ++k) {
    const Occupancy cells = random_cells(random);
    const DistanceField field(cells);
    const WallRuns walls(cells, 1.5);
    const Bounds b = cells.bounds();
    for (int i = 0; i < 50; ++i) {
      const TPoint2D p(uniform_real(random, b.x_min, b.x_max),
                       uniform_real(random, b.y_min, b.y_max));
      const double clearance = field.clearance(p);
      if (clearance == 0) continue;  // in an occupied cell
      double nearest = std::numeric_limits<double>::infinity(), facing = nearest;
      for (const std::size_t run : walls.near(p)) {
        const auto& [from, to, to_free] = walls.runs()[run];
        const double distance = (nearest_on_segment(p, from, to) - p).norm();
        nearest = std::min(nearest, distance);
        if ((p.x - from.x) * to_free.x + (p.y - from.y) * to_free.y > 0)
          facing = std::min(facing, distance);
      }
      if (clearance < 1.5) {
        EXPECT_NEAR(nearest, clearance, 1e-12);
        EXPECT_NEAR(facing, clearance, 1e-12);
      } else {
        EXPECT_GE(nearest, clearance - 1e-12);
      }
    }
  }
}

TEST(WallRuns, AreMaximal) {
  Occupancy cells(6, 4, 0.5, {0, 0});
  for (int x = 1; x < 5; ++x) cells.set_occupied(x, 2, true);
  // Four sides of the workspace, four of the bar.
  EXPECT_EQ(find_wall_runs(cells).size(), 8U);
  cells.set_occupied(2, 1, true);  // a step: the lower side is cut, three sides more
  EXPECT_EQ(find_wall_runs(cells).size(), 12U);
}

}  // namespace
}  // namespace slalom
