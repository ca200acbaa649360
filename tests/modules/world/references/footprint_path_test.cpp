// SPDX-License-Identifier: BSD-3-Clause
#include "reference_worlds.h"

#include <slalom/core/distance.h>
#include <slalom/core/pose.h>
#include <slalom/core/random.h>
#include <slalom/references/disc_path.h>
#include <slalom/references/footprint_path.h>

// Keeps a note about a header of Boost 1.74 that its own geometry includes out of the build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using Point = boost::geometry::model::d2::point_xy<double>;
using Shape = boost::geometry::model::polygon<Point, false>;

constexpr double kMargin = 0.01;

Shape shape_of(const std::vector<TPoint2D>& corners) {
  Shape shape;
  for (const TPoint2D& p : corners) shape.outer().emplace_back(p.x, p.y);
  shape.outer().push_back(shape.outer().front());
  return shape;
}

/// m, from the robot to the nearest occupied square or to the outside: by another library.
double gap_at(const World& world, const Footprint& footprint, const TPose2D& pose) {
  const Occupancy& cells = world.occupancy();
  const Shape robot = shape_of(footprint.corners_at(pose));
  const double r = cells.resolution(), reach = footprint.enclosing_radius() + 2 * r;
  const TPoint2D center = cells.to_cells(TPoint2D(pose));
  const int n = static_cast<int>(std::ceil(reach / r));
  double gap = reach;
  for (int y = static_cast<int>(center.y) - n; y <= static_cast<int>(center.y) + n; ++y)
    for (int x = static_cast<int>(center.x) - n; x <= static_cast<int>(center.x) + n; ++x) {
      if (!cells.occupied(x, y)) continue;
      const TPoint2D a = cells.to_world(x, y), b = cells.to_world(x + 1, y + 1);
      const Shape square = shape_of({a, {b.x, a.y}, b, {a.x, b.y}});
      gap = std::min(gap, boost::geometry::distance(robot, square));
    }
  return gap;
}

/// The path is what its header says.
void expect_valid(const World& world, const Footprint& footprint, const FootprintPath& path) {
  const Scenario& scenario = world.scenario();
  ASSERT_EQ(path.poses.front(), scenario.start());
  EXPECT_LE(distance_between(path.poses.back(), scenario.goal()), footprint.half_width() / 6);
  double length = 0;
  for (std::size_t i = 1; i < path.poses.size(); ++i) {
    const TPose2D &from = path.poses[i - 1], &to = path.poses[i];
    const double driven = distance_between(from, to);
    length += driven;
    if (driven > 0) {
      EXPECT_TRUE(from.phi == to.phi || path.motion == PolygonMotion::Holonomic)
          << "turns while it drives";
      const double ahead = inverse_compose(from, TPoint2D(to)).x;
      EXPECT_NEAR(path.motion == PolygonMotion::Forward     ? ahead
                  : path.motion == PolygonMotion::Reversing ? std::abs(ahead)
                                                            : driven,
                  driven, 1e-9);
    }
    for (int k = 0; k <= 4; ++k)
      ASSERT_GT(gap_at(world, footprint, interpolate(from, to, k / 4.0)), kMargin);
  }
  EXPECT_NEAR(path.length, length, 1e-9);
}

std::optional<FootprintPath> find_path(const World& world, const Footprint& footprint,
                                       std::string& reason,
                                       PolygonMotion motion = PolygonMotion::Forward) {
  return find_footprint_path(world, footprint, world.scenario().start(), world.scenario().goal(),
                             kMargin, reason, SearchEffort::Thorough, motion);
}

/// A wall with a door of this width (m); the way leads through it at an angle.
World door(double width) {
  Primitives walls;
  const double low = 3 - width / 2, high = 3 + width / 2;
  walls.polygons = {{{{2.91, 0}, {3.09, 0}, {3.09, low}, {2.91, low}}},
                    {{{2.91, high}, {3.09, high}, {3.09, 6}, {2.91, 6}}}};
  return {Scenario::continuous("door", {0, 0, 6, 6}, walls, {1.2, 1.2, 2}, {4.8, 4.5}), 0.02};
}

TEST(FootprintPath, LeadsThroughADoorThatIsWiderThanTheRobot) {
  std::string reason;
  for (const char* text : {kRectangle, kRearAxle}) {
    const Footprint footprint = Footprint::parse(text);
    for (const double slack : {0.08, 0.14, 0.4}) {
      const World world = door(2 * footprint.half_width() + slack);
      const auto path = find_path(world, footprint, reason);
      ASSERT_TRUE(path) << reason << " " << slack;
      expect_valid(world, footprint, *path);
    }
    EXPECT_FALSE(find_path(door(2 * footprint.half_width() - 0.02), footprint, reason));
    EXPECT_NE(reason, "");
  }
}

/// A corridor from x = 1 to x = 7 of this width (m), too narrow for the rectangle to turn.
World corridor(double width, double heading) {
  Primitives walls;
  const double low = 3 - width / 2, high = 3 + width / 2;
  walls.polygons = {{{{0, 0}, {8, 0}, {8, low}, {0, low}}},
                    {{{0, high}, {8, high}, {8, 6}, {0, 6}}},
                    {{{0, low}, {1, low}, {1, high}, {0, high}}},
                    {{{7, low}, {8, low}, {8, high}, {7, high}}}};
  return {Scenario::continuous("corridor", {0, 0, 8, 6}, walls, {2, 3, heading}, {6, 3}), 0.02};
}

TEST(FootprintPath, OtherMotionsAreUsedOnlyWhereNoFormerLeads) {
  const Footprint footprint = Footprint::parse(kRectangle);
  const double length = 0.84, width = 0.42;
  const struct {
    double width, heading;
    PolygonMotion needed;
  } cases[] = {{width + 0.1, 0, PolygonMotion::Forward},
               {width + 0.1, M_PI, PolygonMotion::Reversing},
               {length + 0.07, M_PI / 2, PolygonMotion::Holonomic}};
  for (const auto& c : cases)
    for (const PolygonMotion motion :
         {PolygonMotion::Forward, PolygonMotion::Reversing, PolygonMotion::Holonomic}) {
      std::string reason;
      const World world = corridor(c.width, c.heading);
      const auto path = find_path(world, footprint, reason, motion);
      ASSERT_EQ(path.has_value(), motion >= c.needed) << c.width << " " << reason;
      if (!path) continue;
      EXPECT_EQ(path->motion, c.needed);
      EXPECT_NEAR(path->length, 4, 0.05);
      expect_valid(world, footprint, *path);
    }
}

TEST(FootprintPath, LeadsAroundABendInWhichTheRobotJustFitsButCannotTurn) {
  // A corridor of 0.3 m; the robot is 0.3 m by 0.26 m, its diagonal 0.4 m.
  Primitives walls;
  const auto box = [&](double left, double low, double right, double high) {
    walls.polygons.push_back({{{left, low}, {right, low}, {right, high}, {left, high}}});
  };
  box(0, 0, 3.21, 0.84);
  box(0, 1.16, 2.89, 4);
  box(3.21, 0, 4, 4);
  const World bend(Scenario::continuous("bend", {0, 0, 4, 4}, walls, {0.5, 1, 0}, {3.05, 3.5}),
                   0.05);
  const Footprint footprint = Footprint::parse("0.15,0.13; -0.15,0.13; -0.15,-0.13; 0.15,-0.13");
  for (const PolygonMotion motion : {PolygonMotion::Reversing, PolygonMotion::Holonomic}) {
    std::string reason;
    const auto path =
        find_footprint_path(bend, footprint, bend.scenario().start(), bend.scenario().goal(), 0,
                            reason, SearchEffort::Thorough, motion);
    ASSERT_EQ(path.has_value(), motion == PolygonMotion::Holonomic) << reason;
    if (!path) continue;
    EXPECT_NEAR(path->length, 2.55 + 2.5, 0.1);
  }
}

TEST(FootprintPath, NoDiscInTheRobotHasAPathIsAProof) {
  std::string reason;
  EXPECT_FALSE(find_path(door(0.38), Footprint::parse(kRectangle), reason));
  EXPECT_EQ(reason, "no path from start to goal is wide enough for the robot");
}

/// Squares at random places in a room, away from start and goal.
World clutter(std::uint64_t seed) {
  RandomEngine engine(seed);
  Primitives squares;
  while (squares.polygons.size() < 16) {
    const TPoint2D at(uniform_real(engine, 0, 8), uniform_real(engine, 0, 8));
    if (distance_between(at, TPoint2D(1.2, 1.2)) < 1.3 ||
        distance_between(at, TPoint2D(6.8, 6.8)) < 1.3)
      continue;
    const double r = uniform_real(engine, 0.1, 0.4);
    squares.polygons.push_back(
        {{{at.x - r, at.y - r}, {at.x + r, at.y - r}, {at.x + r, at.y + r}, {at.x - r, at.y + r}}});
  }
  return {Scenario::continuous("clutter", {0, 0, 8, 8}, squares,
                               {1.2, 1.2, uniform_real(engine, -M_PI, M_PI)}, {6.8, 6.8}),
          0.05};
}

TEST(FootprintPath, KeepsTheMarginForAnyShapeInAnyRoom) {
  int found = 0, passable = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const World world = clutter(seed);
    for (const char* text : {kRectangle, kRearAxle, kCorner}) {
      const Footprint footprint = Footprint::parse(text);
      std::string reason;
      const auto path = find_path(world, footprint, reason);
      // Wherever the enclosing disc passes with the margin, so does the robot.
      const bool is_easy =
          shortest_disc_path(world.occupancy(), footprint.enclosing_radius() + 3 * kMargin,
                             {1.2, 1.2}, {6.8, 6.8}, reason)
              .has_value();
      EXPECT_TRUE(path || !is_easy) << seed << " " << text;
      passable += is_easy ? 1 : 0;
      found += path ? 1 : 0;
      if (path) expect_valid(world, footprint, *path);
    }
  }
  EXPECT_GT(found, passable + 5) << "the shape finds more than its disc";
}

TEST(FootprintPath, IsThatOfADiscOfHalfItsWidthWhereThereIsRoom) {
  Primitives block;
  block.polygons = {{{{3.4, 2}, {4.6, 2}, {4.6, 6}, {3.4, 6}}}};
  const World world(Scenario::continuous("block", {0, 0, 8, 8}, block, {1.2, 4.1, 1}, {6.8, 4.1}),
                    0.05);
  for (const char* text : {kRectangle, kRearAxle}) {
    const Footprint footprint = Footprint::parse(text);
    std::string reason;
    const auto path = find_path(world, footprint, reason);
    ASSERT_TRUE(path) << reason;
    expect_valid(world, footprint, *path);
    const auto length = [&](double radius) {
      return shortest_disc_path(world.occupancy(), radius, {1.2, 4.1}, {6.8, 4.1}, reason)->length;
    };
    EXPECT_GT(path->length, length(footprint.half_width() + kMargin));
    // No wider than a quarter of the way to the enclosing disc, and 0.1 % more of it.
    EXPECT_LT(path->length, 1.001 * length(0.75 * (footprint.half_width() + kMargin) +
                                           0.25 * footprint.enclosing_radius()));
  }
}

TEST(FootprintPath, OfARoundPolygonIsThatOfTheDisc) {
  std::string corners;
  constexpr double kRadius = 0.3;
  for (int i = 0; i < 64; ++i)
    corners += (i > 0 ? "; " : "") + std::to_string(kRadius * std::cos(i * M_PI / 32)) + "," +
               std::to_string(kRadius * std::sin(i * M_PI / 32));
  const Footprint footprint = Footprint::parse(corners);
  for (std::uint64_t seed = 21; seed <= 32; ++seed) {
    const World world = clutter(seed);
    std::string reason;
    const auto path = find_path(world, footprint, reason);
    const auto narrow =
        shortest_disc_path(world.occupancy(), kRadius, {1.2, 1.2}, {6.8, 6.8}, reason);
    const auto wide = shortest_disc_path(world.occupancy(), kRadius + kMargin + 1e-3, {1.2, 1.2},
                                         {6.8, 6.8}, reason);
    EXPECT_TRUE(path || !wide) << seed;
    EXPECT_TRUE(narrow || !path) << seed;
    if (!path || !wide) continue;
    EXPECT_GE(path->length, narrow->length - kRadius / 6);
    EXPECT_LE(path->length, 1.001 * wide->length) << "fewer turns on arcs";
  }
}

}  // namespace
}  // namespace slalom
