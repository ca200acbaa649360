// SPDX-License-Identifier: BSD-3-Clause
#include "random_worlds.h"

#include <slalom/core/error.h>
#include <slalom/scenario/occupancy.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

Scenario continuous(const Bounds& bounds, Primitives obstacles) {
  const TPoint2D corner(bounds.x_min, bounds.y_min);
  return Scenario::continuous("test", bounds, std::move(obstacles), {corner.x, corner.y, 0},
                              corner);
}

/// The closed square of a cell.
Polygon square(const Occupancy& cells, int cx, int cy) {
  return {{cells.to_world(cx, cy), cells.to_world(cx + 1, cy), cells.to_world(cx + 1, cy + 1),
           cells.to_world(cx, cy + 1)}};
}

double distance_between_edges(const Polygon& p, const Polygon& q) {
  double nearest = 1e9;
  const auto half = [&](const Polygon& from, const Polygon& to) {
    for (const TPoint2D& vertex : from.vertices) nearest = std::min(nearest, distance(vertex, to));
  };
  half(p, q);
  half(q, p);
  return nearest;
}

bool edges_cross(const Polygon& p, const Polygon& q) {
  const auto side = [](const TPoint2D& a, const TPoint2D& b, const TPoint2D& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
  };
  for (std::size_t i = 0; i < p.vertices.size(); ++i)
    for (std::size_t k = 0; k < q.vertices.size(); ++k) {
      const TPoint2D &a = p.vertices[i], &b = p.vertices[(i + 1) % p.vertices.size()];
      const TPoint2D &c = q.vertices[k], &d = q.vertices[(k + 1) % q.vertices.size()];
      if (side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)) return true;
    }
  return false;
}

/// Distance from a cell's square to an obstacle, by plain geometry.
double gap(const Occupancy& cells, int cx, int cy, const Primitives& obstacles) {
  const Polygon cell = square(cells, cx, cy);
  double nearest = 1e9;
  for (const Disc& disc : obstacles.discs)
    nearest = std::min(nearest, distance(disc.center, cell) - disc.radius);
  for (const Polygon& polygon : obstacles.polygons)
    nearest =
        std::min(nearest, edges_cross(cell, polygon) ? -1 : distance_between_edges(cell, polygon));
  return nearest;
}

TEST(Occupancy, OccupiesExactlyTheCellsThatObstaclesTouch) {
  RandomEngine random(4);
  for (int n = 0; n < 300; ++n) {
    const Bounds bounds{-1.3, 0.2, 2.7, 3.2};
    const Scenario scenario = continuous(bounds, testing::random_primitives(random, bounds, 2));
    const Occupancy cells = make_occupancy(scenario, uniform_int(random, 0, 1) ? 0.1 : 0.25);
    for (int cy = 0; cy < cells.size_y(); ++cy)
      for (int cx = 0; cx < cells.size_x(); ++cx) {
        const double away = gap(cells, cx, cy, scenario.primitives());
        if (away > 0 && away < 1e-8) continue;  // touching depends on rounding
        ASSERT_EQ(cells.occupied(cx, cy), away <= 0) << cx << ' ' << cy << ' ' << away;
      }
  }
}

TEST(Occupancy, CountsTouchingAsOccupied) {
  // The disc around (1, 1) with radius 0.5 touches x = 1.5 and x = 0.5 at y = 1 only; cells of 0.5
  // m.
  const Occupancy disc = make_occupancy(continuous({0, 0, 3, 3}, {{{{1, 1}, 0.5}}, {}}), 0.5);
  EXPECT_TRUE(disc.occupied(3, 1));
  EXPECT_TRUE(disc.occupied(3, 2));
  EXPECT_TRUE(disc.occupied(0, 1));
  EXPECT_FALSE(disc.occupied(3, 3));
  EXPECT_FALSE(disc.occupied(0, 0));
  EXPECT_EQ(disc.count_occupied(), 4U + 4 * 2);
  // A square from (1, 1) to (2, 2) covers four cells of 0.5 m and touches the twelve around them.
  const Polygon square{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
  EXPECT_EQ(make_occupancy(continuous({0, 0, 3, 3}, {{}, {square}}), 0.5).count_occupied(), 16U);
}

TEST(Occupancy, CountsCellsOutsideAsOccupied) {
  const Occupancy cells(3, 2, 0.5, {1, 1});
  EXPECT_FALSE(cells.occupied(0, 0));
  EXPECT_TRUE(cells.occupied(-1, 0));
  EXPECT_TRUE(cells.occupied(3, 1));
  EXPECT_TRUE(cells.occupied(1, 2));
  EXPECT_EQ(cells.count_occupied(), 0U);
  EXPECT_EQ(cells.bounds(), (Bounds{1, 1, 2.5, 2}));
}

TEST(Occupancy, OccupiesCellsThatReachBeyondTheBounds) {
  const Occupancy cells = make_occupancy(continuous({0, 0, 1.05, 0.7}, {}), 0.1);
  EXPECT_EQ(cells.size_x(), 11);
  EXPECT_EQ(cells.size_y(), 7) << "0.7 / 0.1 rounds to a little below or above 7";
  EXPECT_EQ(cells.count_occupied(), 7U);
  for (int cy = 0; cy < 7; ++cy) EXPECT_TRUE(cells.occupied(10, cy));
}

TEST(Occupancy, HasNoExtraCellWhereTheSizeIsAMultipleOfTheResolution) {
  for (const double resolution : {0.02, 0.05, 0.1, 0.15, 0.3, 0.7})
    for (int n = 1; n < 300; ++n) {
      const Occupancy cells =
          make_occupancy(continuous({-3.3, 1.1, -3.3 + n * resolution, 2.1}, {}), resolution);
      ASSERT_EQ(cells.size_x(), n);
      ASSERT_FALSE(cells.occupied(n - 1, 0));
    }
}

TEST(Occupancy, OccupiesTheCellThatContainsAPoint) {
  mrpt::maps::CSimplePointsMap points;
  points.insertPoint(0.25F, 0.75F);
  points.insertPoint(2.0F, 1.0F);  // the far corner belongs to the last cell
  points.insertPoint(-5.0F, 0.5F);
  const Scenario scenario = Scenario::points("test", {0, 0, 2, 1}, points, {1, 0.5, 0}, {1, 0.5});
  const Occupancy cells = make_occupancy(scenario, 0.5);
  EXPECT_EQ(cells.count_occupied(), 2U);
  EXPECT_TRUE(cells.occupied(0, 1));
  EXPECT_TRUE(cells.occupied(3, 1));
}

TEST(Occupancy, RefusesResolutionsWithNoneOrTooManyCells) {
  const Scenario scenario = continuous({0, 0, 100, 100}, {});
  for (const double resolution : {0.0, -1.0, 1e-4, std::nan(""), HUGE_VAL})
    EXPECT_THROW(make_occupancy(scenario, resolution), Error) << resolution;
  EXPECT_THROW(Occupancy(0, 3, 0.1, {0, 0}), Error);
  EXPECT_THROW(Occupancy(100000, 100000, 0.1, {0, 0}), Error);
}

}  // namespace
}  // namespace slalom
