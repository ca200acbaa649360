// SPDX-License-Identifier: BSD-3-Clause
#include "test_runs.h"

#include <slalom/references/footprint_contact.h>
#include <slalom/simulation/run_observer.h>

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// A robot and rectangles which it is made of.
struct Shape {
  const char* footprint;
  std::vector<std::vector<TPoint2D>> parts;
};

std::vector<TPoint2D> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

constexpr char kLongRobot[] = "0.35,0.12; -0.2,0.12; -0.2,-0.12; 0.35,-0.12";
/// Two arms of 0.3 m by 0.08 m, 0.24 m apart.
constexpr char kFork[] =
    "0.3,0.2; 0.3,0.12; 0.05,0.12; 0.05,-0.12; 0.3,-0.12; 0.3,-0.2; -0.2,-0.2; -0.2,0.2";

std::vector<Shape> shapes() {
  return {{kLongRobot, {rectangle(-0.2, -0.12, 0.35, 0.12)}},
          {kFork,
           {rectangle(-0.2, -0.2, 0.05, 0.2), rectangle(0, 0.12, 0.3, 0.2),
            rectangle(0, -0.2, 0.3, -0.12)}}};
}

std::vector<TPoint2D> moved(std::vector<TPoint2D> points, const TPose2D& pose) {
  for (TPoint2D& p : points) p = pose.composePoint(p);
  return points;
}

/// Whether a polygon and the closed square [x0, x1] x [y0, y1] fraction a point, by separating
/// axes.
bool overlap(const std::vector<TPoint2D>& polygon, double x0, double y0, double x1, double y1) {
  const std::vector<TPoint2D> square = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  std::vector<TPoint2D> axes = {{1, 0}, {0, 1}};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const TPoint2D edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    axes.emplace_back(-edge.y, edge.x);
  }
  for (const TPoint2D& axis : axes) {
    const auto extent = [&axis](const std::vector<TPoint2D>& points) {
      double low = 1e300, high = -1e300;
      for (const TPoint2D& p : points) {
        low = std::min(low, p.x * axis.x + p.y * axis.y);
        high = std::max(high, p.x * axis.x + p.y * axis.y);
      }
      return std::pair(low, high);
    };
    const auto [a, b] = extent(polygon);
    const auto [c, d] = extent(square);
    if (b < c || d < a) return false;
  }
  return true;
}

bool brute_touch(const Occupancy& cells, const Shape& shape, const TPose2D& pose) {
  const TPoint2D at = cells.to_cells({pose.x, pose.y});
  const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
  constexpr int kReach = 5;  // cells of 0.1 m, more than the robot's 0.37 m
  for (int cy = y - kReach; cy <= y + kReach; ++cy)
    for (int cx = x - kReach; cx <= x + kReach; ++cx) {
      if (!cells.occupied(cx, cy)) continue;
      const TPoint2D low = cells.to_world(cx, cy), high = cells.to_world(cx + 1, cy + 1);
      for (const auto& part : shape.parts)
        if (overlap(moved(part, pose), low.x, low.y, high.x, high.y)) return true;
    }
  return false;
}

TEST(FootprintContact, PolygonTouchesOverlappingCells) {
  RandomEngine random(7);
  int touching = 0, clear = 0;
  for (int n = 0; n < 40; ++n) {
    const World world = random_cells(random, 0.02);
    const Shape shape = shapes()[static_cast<std::size_t>(n % 2)];
    const Footprint footprint = Footprint::parse(shape.footprint);
    const auto contact = make_footprint_contact(world, footprint);
    for (int k = 0; k < 50; ++k) {
      const TPose2D pose{uniform_real(random, 0, 6), uniform_real(random, 0, 6),
                         uniform_real(random, -3, 3)};
      // Contact counts from 0.1 mm on.
      const bool expected =
          brute_touch(world.occupancy(), shape, pose) ||
          world.distance_field().outline_clearance(footprint.corners_at(pose)) < 1e-4;
      EXPECT_EQ(contact->touches(pose), expected) << shape.footprint << " at " << pose;
      ++(expected ? touching : clear);
    }
  }
  EXPECT_GT(touching, 200);
  EXPECT_GT(clear, 200);
}

TEST(FootprintContact, SweptPolygonStopsAtItsFirstContact) {
  RandomEngine random(8);
  int contacts = 0;
  for (int n = 0; n < 200; ++n) {
    const World world = random_cells(random, 0.03);
    const Shape shape = shapes()[static_cast<std::size_t>(n % 2)];
    const Footprint footprint = Footprint::parse(shape.footprint);
    const auto contact = make_footprint_contact(world, footprint);
    const TPose2D from{3, 3, uniform_real(random, -3, 3)};
    const TPose2D to{3 + uniform_real(random, -2, 2), 3 + uniform_real(random, -2, 2),
                     from.phi + uniform_real(random, -2, 2)};
    TPose2D reached = to;
    double fraction = 1;
    const bool hit = contact->find_contact(from, reached, fraction);
    // Brute force: the first of 1000 interpolated poses that touches.
    double first = 2;
    for (int k = 0; k <= 1000 && first > 1; ++k) {
      const double at = k / 1000.0;
      const TPose2D pose{from.x + at * (to.x - from.x), from.y + at * (to.y - from.y),
                         from.phi + at * (to.phi - from.phi)};
      if (brute_touch(world.occupancy(), shape, pose)) first = at;
    }
    if (first <= 1) {
      ASSERT_TRUE(hit);
      // Contact counts from 0.1 mm on, which a grazing outline reaches before it touches.
      EXPECT_LE(fraction, first + 1e-9);
      ++contacts;
    }
    if (hit) {
      EXPECT_LT(world.distance_field().outline_clearance(footprint.corners_at(reached)), 1e-4);
    }
  }
  EXPECT_GT(contacts, 80);
}

/// Its center stops 0.05 m before a pillar that fits between its arms; its convex hull touches the
/// pillar 0.25 m earlier.
TEST(FootprintContact, AnObstacleMayBeBetweenTheArmsOfARobot) {
  Primitives pillar;
  pillar.polygons.push_back({rectangle(5.01, 4.96, 5.09, 5.04)});
  const World world = square_world({2, 5, 0}, {9, 1}, pillar);
  const Footprint fork = Footprint::parse(kFork);
  const auto contact = make_footprint_contact(world, fork);
  TPose2D reached{6, 5, 0};
  double fraction = 1;
  EXPECT_FALSE(contact->touches({4.9, 5, 0}));
  ASSERT_TRUE(contact->find_contact({4, 5, 0}, reached, fraction));
  EXPECT_NEAR(reached.x, 4.95, 2e-4);
  // The arms do not fit around it obliquely.
  EXPECT_TRUE(contact->touches({4.9, 5, 0.6}));
}

TEST(FootprintContact, RobotRotatingInPlaceHitsAWallNextToItsLongSide) {
  // 0.3 m from its center to a wall on its left: the front corner, 0.37 m away, sweeps into it.
  Primitives wall;
  wall.polygons.push_back({{{0, 5.3}, {10, 5.3}, {10, 6}, {0, 6}}});
  const World world = square_world({5, 5, 0}, {9, 1}, wall);
  RunSetup setup;
  setup.robot.footprint = kLongRobot;
  setup.robot.radius = setup.robot.shape().enclosing_radius();
  auto turning = constant_method(0, 1);
  EXPECT_EQ(simulate(world, setup, 1, turning).outcome, Outcome::Collision);
  setup.robot.footprint.clear();
  setup.robot.radius = 0.25;
  EXPECT_NE(simulate(world, setup, 1, turning).outcome, Outcome::Collision);
}

}  // namespace
}  // namespace slalom::testing
