// SPDX-License-Identifier: BSD-3-Clause
#include "reference_worlds.h"

#include <slalom/references/safest_path.h>
#include <slalom/references/voronoi_diagram.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace slalom {
namespace {

bool contains(const std::vector<std::uint8_t>& diagram, const World& world,
              const mrpt::math::TPoint2D& p) {
  const auto at = world.occupancy().to_cells(p);
  return diagram[world.occupancy().index(static_cast<int>(at.x), static_cast<int>(at.y))] != 0;
}

TEST(VoronoiDiagram, OfACorridorIsItsCenterLine) {
  // 20 m by 3.05 m at 0.05 m: 61 rows, of which the middle one is centered at y = 1.525.
  const World world(Scenario::continuous("corridor", {0, 0, 20, 3.05}, {}, {1, 1, 0}, {19, 1}),
                    0.05);
  const auto diagram = voronoi_diagram(world, 0.25);
  for (const double x : {3.02, 10.02, 16.98}) {
    EXPECT_TRUE(contains(diagram, world, {x, 1.525})) << x;
    for (const double y : {0.5, 1.0, 1.4, 1.65, 2.5})
      EXPECT_FALSE(contains(diagram, world, {x, y})) << x << ", " << y;
  }
}

TEST(VoronoiDiagram, KeepsTheMinimumClearance) {
  RandomEngine engine(4);
  const World world = random_world(engine, 8, 15);
  const auto diagram = voronoi_diagram(world, 0.3);
  const auto wider = voronoi_diagram(world, 0.6);
  ASSERT_GT(std::count(wider.begin(), wider.end(), 1), 0);
  for (std::size_t i = 0; i < diagram.size(); ++i) {
    const double clearance = world.distance_field().centers()[i];
    EXPECT_TRUE(!diagram[i] || clearance >= 0.3F);
    EXPECT_EQ(wider[i] != 0, diagram[i] != 0 && clearance >= 0.6F);
  }
}

}  // namespace
}  // namespace slalom
