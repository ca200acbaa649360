// SPDX-License-Identifier: BSD-3-Clause
#include "random_worlds.h"

#include <slalom/core/error.h>
#include <slalom/scenario/occupancy.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

Scenario sample(RandomEngine& random) {
  const Bounds bounds{-4.425, 5.1, 1.575, 9.1};
  return Scenario::continuous("sample", bounds, testing::random_primitives(random, bounds, 4),
                              {-2, 6, 0.5}, {1, 8.5});
}

std::vector<TPoint2D> points_of(const Scenario& scenario) {
  std::vector<TPoint2D> points;
  const auto& map = *scenario.point_map();
  for (std::size_t i = 0; i < map.size(); ++i)
    points.emplace_back(map.getPointsBufferRef_x()[i], map.getPointsBufferRef_y()[i]);
  return points;
}

TEST(Convert, MakesAGridOfTheSameCellsAsTheOccupancy) {
  RandomEngine random(5);
  for (const double resolution : {0.05, 0.1, 0.13, 0.025}) {
    const Scenario scenario = sample(random);
    const Occupancy cells = make_occupancy(scenario, resolution);
    const Scenario grid = convert(scenario, Representation::Grid, resolution);
    const Occupancy again = make_occupancy(grid, 99);
    EXPECT_EQ(grid.representation(), Representation::Grid);
    EXPECT_EQ(again.size_x(), cells.size_x());
    EXPECT_EQ(again.cells(), cells.cells());
    EXPECT_NEAR(again.resolution(), resolution, 1e-7 * resolution);
    EXPECT_NEAR(again.origin().x, cells.origin().x, 1e-6);
    EXPECT_EQ(grid.name(), scenario.name());
    EXPECT_EQ(grid.start(), scenario.start());
    EXPECT_EQ(grid.goal(), scenario.goal());
    EXPECT_NE(grid.hash(), scenario.hash());
  }
}

TEST(Convert, PutsPointsOnTheBoundariesOfPrimitives) {
  RandomEngine random(6);
  const double spacing = 0.04;
  const Scenario scenario = sample(random);
  const Primitives& obstacles = scenario.primitives();
  ASSERT_FALSE(obstacles.discs.empty() && obstacles.polygons.empty());
  const auto points = points_of(convert(scenario, Representation::Points, spacing));
  const auto to_boundary = [&](const TPoint2D& p) {
    double nearest = 1e9;
    for (const Disc& d : obstacles.discs)
      nearest =
          std::min(nearest, std::abs(std::hypot(p.x - d.center.x, p.y - d.center.y) - d.radius));
    for (const Polygon& polygon : obstacles.polygons)
      for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
        nearest = std::min(
            nearest, distance_to_segment(p, polygon.vertices[i],
                                         polygon.vertices[(i + 1) % polygon.vertices.size()]));
    return nearest;
  };
  for (const TPoint2D& p : points) {
    EXPECT_LT(to_boundary(p), 1e-5);
    EXPECT_TRUE(scenario.bounds().contains(p));
  }
  for (const Disc& disc :
       obstacles.discs)  // no gap: every position on a rim has a point close to it
    for (double angle = 0; angle < 6.28; angle += 0.01) {
      const TPoint2D rim(disc.center.x + disc.radius * std::cos(angle),
                         disc.center.y + disc.radius * std::sin(angle));
      const Bounds& b = scenario.bounds();
      if (!Bounds{b.x_min + spacing, b.y_min + spacing, b.x_max - spacing, b.y_max - spacing}
               .contains(rim))
        continue;
      double nearest = 1e9;
      for (const TPoint2D& p : points)
        nearest = std::min(nearest, std::hypot(p.x - rim.x, p.y - rim.y));
      ASSERT_LE(nearest, 0.5 * spacing + 1e-5);
    }
}

TEST(Convert, PutsPointsInBorderCellsOfAGridAndBack) {
  mrpt::maps::COccupancyGridMap2D map;
  map.setSize(0, 1, 0, 0.5F, 0.1F, 1.0F);
  for (int cx = 2; cx <= 4; ++cx)
    for (int cy = 1; cy <= 3; ++cy) map.setCell(cx, cy, 0.0F);
  map.setCell(9, 0, 0.0F);
  const Scenario grid = Scenario::grid("block", map, {0.05, 0.05, 0}, {0.85, 0.45});
  const Scenario points = convert(grid, Representation::Points, 0.1);
  EXPECT_EQ(points_of(points).size(), 9U)
      << "the block without its inner cell, and the corner cell";
  const Occupancy cells = make_occupancy(convert(points, Representation::Grid, 0.1), 0.1);
  for (int cy = 0; cy < 5; ++cy)
    for (int cx = 0; cx < 10; ++cx) {
      const bool border = cx >= 2 && cx <= 4 && cy >= 1 && cy <= 3 && !(cx == 3 && cy == 2);
      EXPECT_EQ(cells.occupied(cx, cy), border || (cx == 9 && cy == 0)) << cx << ' ' << cy;
    }
}

TEST(Convert, KeepsAScenarioOfTheSameRepresentation) {
  RandomEngine random(7);
  const Scenario scenario = sample(random);
  EXPECT_EQ(convert(scenario, Representation::Continuous, 0).hash(), scenario.hash());
  const Scenario grid = convert(scenario, Representation::Grid, 0.1);
  EXPECT_EQ(convert(grid, Representation::Grid, 0.3).hash(), grid.hash());
}

TEST(Convert, RefusesInvalidResolutions) {
  RandomEngine random(8);
  const Scenario scenario = sample(random);
  EXPECT_THROW(convert(scenario, Representation::Grid, 0), Error);
  EXPECT_THROW(convert(scenario, Representation::Points, -1), Error);
  EXPECT_THROW(convert(scenario, Representation::Points, 1e-12), Error);
}

}  // namespace
}  // namespace slalom
