// SPDX-License-Identifier: BSD-3-Clause
// Descriptors of the free space, with or without the robot's size, in worlds with 1 m cells.
#include "../small_worlds.h"

#include <slalom/core/random.h>
#include <slalom/scenario/convert.h>

// Keeps a note about a header of Boost 1.74 that its own geometry includes out of the build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

TEST(Clearness, IsTheMeanDistanceOverTheRange) {
  // One row of five cells, walls all around: the distance of every center to the wall above is half
  // a cell.
  const World world = drawn_world({"S...G"});
  EXPECT_NEAR(value_of("clearness", context_of(world, 0.25, 2.0)), 0.5 / 2, 1e-6);
}

TEST(Clearness, DistancesBeyondTheRangeCountAsTheRange) {
  // 5 x 5 without obstacles: 16 centers lie 0.5 m from the wall, 8 lie 1.5 m, one 2.5 m; cut at 1
  // m.
  const World world = drawn_world({".....", ".....", "S...G", ".....", "....."});
  EXPECT_NEAR(value_of("clearness", context_of(world, 0.25, 1.0)), (16 * 0.5 + 9 * 1.0) / 25, 1e-6);
  EXPECT_NEAR(value_of("clearness", context_of(world, 0.25, 4.0)),
              (16 * 0.5 + 8 * 1.5 + 2.5) / (4 * 25), 1e-6);
}

TEST(ClearnessMeanDistance, IsTheMeanOverFreeCenters) {
  // 16 centers 0.5 m from the wall, 8 at 1.5 m, one at 2.5 m.
  EXPECT_NEAR(value_of("clearness_mean_distance", context_of(drawn_world(kEmpty))),
              (16 * 0.5 + 8 * 1.5 + 2.5) / 25, 1e-6);
  // A block in a corner occupies its own cell. It is sqrt(0.5) m from the cell at its corner,
  // instead of 1.5 m, and sqrt(4.5) m from the middle one, instead of 2.5 m.
  const World block = drawn_world({".....", ".....", "S...G", ".....", "#...."});
  EXPECT_NEAR(value_of("clearness_mean_distance", context_of(block)),
              (15 * 0.5 + std::sqrt(0.5) + 7 * 1.5 + std::sqrt(4.5)) / 24, 1e-6);
}

TEST(ClearanceMean, IsTheMeanOverCollisionFreeCells) {
  EXPECT_NEAR(value_of("clearance_mean", context_of(drawn_world(kEmpty), 0.6)), (8 * 1.5 + 2.5) / 9,
              1e-6);
  EXPECT_EQ(descriptor("clearance_mean").compute(context_of(drawn_world(kEmpty), 2.6)).reason(),
            "no collision-free configuration");
}

TEST(ClearanceQ05, IsTheFivePercentQuantile) {
  // The middle 5 of 3 x 7 centers are 1.5 m from walls, the others 0.5 m. For a robot of 0.6 m only
  // the 5 remain.
  const World hall = drawn_world({".......", "S.....G", "......."});
  EXPECT_NEAR(value_of("clearance_q05", context_of(hall, 0.6)), 1.5, 1e-6);
  EXPECT_NEAR(value_of("clearance_q05", context_of(hall, 0.25)), 0.5, 1e-6);
  EXPECT_EQ(descriptor("clearance_q05").compute(context_of(hall, 1.6)).reason(),
            "no collision-free configuration");
}

TEST(CspaceDensity, IsTheFractionOfCellsInCollision) {
  const World empty = drawn_world(kEmpty);
  EXPECT_DOUBLE_EQ(value_of("cspace_density", context_of(empty, 0.5)), 0)
      << "contact counts as free";
  // Centers next to a wall are 0.5 m from it; 9 others remain.
  EXPECT_DOUBLE_EQ(value_of("cspace_density", context_of(empty, 0.6)), 1 - 9.0 / 25);
  // A block in the middle of those 9 excludes itself and its 4 sides; the 4 cells at its corners
  // are sqrt(0.5) = 0.71 m from it.
  const World block = drawn_world({".....", ".....", "S.#.G", ".....", "....."});
  EXPECT_DOUBLE_EQ(value_of("cspace_density", context_of(block, 0.6)), 1 - 4.0 / 25);
  EXPECT_DOUBLE_EQ(value_of("cspace_density", context_of(block, 0.75)), 1);
}

TEST(CspaceDensity, OfAPolygonIsTheMeanOverSixteenHeadings) {
  // 2.4 m x 0.8 m. Rotated by a it extends 1.2 |cos a| + 0.4 |sin a| along x. Along its length at 0
  // and 90 degrees: 1.2 and 0.4 m, that is 3 and 5 of the distances 0.5, 1.5, 2.5, 1.5, 0.5 m of
  // centers from the walls, 15 cells. At 22.5 degrees 1.26 and 0.83 m, at 45 degrees 1.13 m: 3 and
  // 3, 9 cells.
  const World empty = drawn_world(kEmpty);
  const DescriptorContext context{empty, Footprint::parse("-1.2,-0.4; 1.2,-0.4; 1.2,0.4; -1.2,0.4"),
                                  8, context_of(empty).shortest};
  EXPECT_DOUBLE_EQ(value_of("cspace_density", context), 1 - (4 * 15 + 12 * 9) / (16 * 25.0));
}

TEST(CspaceDensity, OfAPolygonInACorridorCountsTheHeadingsAlongIt) {
  // Forward and backward, at the three cells that are 1.2 m from both ends.
  const World corridor = drawn_world({"#####", "S...G", "#####"});
  const DescriptorContext context{corridor,
                                  Footprint::parse("-1.2,-0.4; 1.2,-0.4; 1.2,0.4; -1.2,0.4"), 8,
                                  context_of(corridor).shortest};
  EXPECT_DOUBLE_EQ(value_of("cspace_density", context), 1 - 3 * 2 / (16 * 15.0));
  EXPECT_EQ(descriptor("cspace_density").key(context).parameters,
            "footprint=-1.2,-0.4 1.2,-0.4 1.2,0.4 -1.2,0.4");
}

/// Whether a polygon (m) overlaps an occupied cell, by its area in each.
bool overlaps(const Occupancy& cells, const std::vector<mrpt::math::TPoint2D>& corners) {
  namespace bg = boost::geometry;
  using Point = bg::model::d2::point_xy<double>;
  bg::model::polygon<Point, false, false> robot;
  for (const auto& p : corners) bg::append(robot, Point(p.x, p.y));
  double free = 0;
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x) {
      if (cells.occupied(x, y)) continue;
      bg::model::multi_polygon<bg::model::polygon<Point, false, false>> parts;
      bg::intersection(robot, bg::model::box<Point>(Point(x, y), Point(x + 1, y + 1)), parts);
      free += bg::area(parts);
    }
  return free < bg::area(robot) - 1e-10;
}

/// Concave and convex ones, in worlds of 1 m cells.
TEST(CspaceDensity, OfAPolygonCountsTheCellsThatItsAreaOverlaps) {
  RandomEngine random(11);
  for (int n = 0; n < 12; ++n) {
    std::vector<std::string> rows(6, "......");
    for (std::string& row : rows)
      for (char& cell : row) cell = uniform_real(random, 0, 1) < 0.12 ? '#' : '.';
    rows[2] = "S....G";
    const World world = drawn_world(rows);
    std::string text;
    for (int i = 0; i < 7; ++i) {
      const double angle = 2 * M_PI * i / 7, radius = uniform_real(random, 0.2, 2.5);
      text += (i > 0 ? ";" : "") + std::to_string(radius * std::cos(angle)) + "," +
              std::to_string(radius * std::sin(angle));
    }
    const Footprint robot = Footprint::parse(text);
    int blocked = 0;
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 6; ++x)
        for (int heading = 0; heading < 16; ++heading)
          blocked += overlaps(world.occupancy(),
                              robot.corners_at({x + 0.5, y + 0.5, 2 * M_PI * heading / 16}))
                         ? 1
                         : 0;
    const DescriptorContext context{world, robot, 8, context_of(world).shortest};
    EXPECT_NEAR(value_of("cspace_density", context), blocked / (16 * 36.0), 1e-12) << text;
  }
}

TEST(CspaceDensity, APolygonLongerThanTheWorkspaceFitsNowhere) {
  const World empty = drawn_world(kEmpty);
  const DescriptorContext context{empty, Footprint::parse("-1e30,-0.1; 1e30,-0.1; 0,0.1"), 8,
                                  context_of(empty).shortest};
  EXPECT_DOUBLE_EQ(value_of("cspace_density", context), 1);
}

TEST(BottleneckWidth, IsTwiceTheWidestBottleneck) {
  // The opening in the middle wall is one cell, 1 m; the straight row leads through it.
  const World world = drawn_world({"..#..", "..#..", "S...G", "..#..", "..#.."});
  EXPECT_NEAR(value_of("bottleneck_width", context_of(world)), 1.0, 1e-6);
}

TEST(BottleneckWidth, IsNaWhereTheRobotDoesNotFit) {
  const World world = drawn_world({"..#..", "..#..", "S...G", "..#..", "..#.."});
  const Value value = descriptor("bottleneck_width").compute(context_of(world, 0.6));
  ASSERT_TRUE(value.is_na());
  EXPECT_EQ(value.reason(), "unsolvable: narrower than the robot");
  const World walled = drawn_world({"..#..", "..#..", "S.#.G", "..#..", "..#.."});
  EXPECT_TRUE(descriptor("bottleneck_width").compute(context_of(walled)).is_na());
}

TEST(TrapFraction, IsTheFractionOfCellsFromWhichDescentGetsStuck) {
  // Descent leads into the U from its inside (2 cells), the two cells next to its opening, and the
  // column of the start with both corners: 9 of 20 free cells. Above and below the U it passes.
  const World trap = drawn_world({".....", "..##.", "S..#G", "..##.", "....."});
  EXPECT_DOUBLE_EQ(value_of("trap_fraction", context_of(trap)), 9.0 / 20);
  EXPECT_DOUBLE_EQ(value_of("trap_fraction", context_of(drawn_world(kEmpty))), 0);
}

TEST(TrapFraction, UnreachableCellsAreTraps) {
  const World halves = drawn_world({"..#..", "..#..", "S.#.G", "..#..", "..#.."});
  EXPECT_DOUBLE_EQ(value_of("trap_fraction", context_of(halves)), 0.5);
  EXPECT_EQ(descriptor("trap_fraction").compute(context_of(halves, 0.6)).reason(),
            "goal is closer to an obstacle than the robot's radius");
}

TEST(TrapFraction, AcceptsAGoalOnTheBorderForAPointRobot) {
  const World world(Scenario::continuous("corner", {0, 0, 5, 5}, {}, {1, 1, 0}, {5, 5}), 1);
  EXPECT_DOUBLE_EQ(value_of("trap_fraction", context_of(world, 1e-12)), 0);
}

/// Mean free length (m) of the rays in an empty room of x by y cells of 1 m. Points and directions
/// are symmetric under mirrors, so all rays have the mean of the two that head to the upper right,
/// at 22.5 and 67.5 degrees: u m below the upper and v m left of the right wall, they end at the
/// nearer of the two.
double mean_free_length(int x, int y) {
  const double small = std::sin(M_PI / 8), large = std::cos(M_PI / 8);
  double sum = 0;
  for (const double v : lattice_along(x, 1))
    for (const double u : lattice_along(y, 1))
      sum += std::min(v / large, u / small) + std::min(v / small, u / large);
  return sum / 2 / (4 * x * y);
}

TEST(Traversability, IsTheMeanFreeRayInRobotWidths) {
  const double expected = mean_free_length(5, 5);
  EXPECT_NEAR(value_of("traversability", context_of(drawn_world(kEmpty), 0.5)), expected, 1e-9);
  EXPECT_NEAR(value_of("traversability", context_of(drawn_world(kEmpty), 0.25)), 2 * expected,
              1e-9);
}

TEST(Traversability, IsZeroAtOccupiedPoints) {
  // Two of three cells are free, each closed on all sides.
  EXPECT_NEAR(value_of("traversability", context_of(drawn_world({"S#G"}), 0.5)),
              mean_free_length(1, 1) * 2 / 3, 1e-9);
}

TEST(Traversability, OfHugeCellsTakesFourPointsEach) {
  Primitives none;
  const World world(Scenario::continuous("huge", {0, 0, 3e6, 1e6}, none, {1, 1, 0}, {2, 2}), 1e6);
  EXPECT_NEAR(value_of("traversability", context_of(world, 0.5)) / 1e6, mean_free_length(3, 1),
              1e-9);
}

TEST(Traversability, CountsPointsOfWorkspacesWithCellsRoundedDown) {
  // Ten cells of 0.7 m are 6.9999999 m in single precision: seven points along each side.
  const Scenario room = Scenario::continuous("room", {0, 0, 7, 7}, {}, {1, 1, 0}, {2, 2});
  const World grid(convert(room, Representation::Grid, 0.7), 1);
  EXPECT_NEAR(value_of("traversability", context_of(grid)),
              value_of("traversability", context_of(World(room, 0.7))), 1e-6);
}

}  // namespace
}  // namespace slalom
