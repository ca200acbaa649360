// SPDX-License-Identifier: BSD-3-Clause
#include "disc_problems.h"
#include "tangent_graph.h"

#include <slalom/references/disc_path.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Radius, start and goal in cells.
std::optional<DiscPath> solve(const Occupancy& cells, double radius, const TPoint2D& start,
                              const TPoint2D& goal, std::string* why = nullptr) {
  std::string reason;
  const auto path =
      shortest_disc_path(cells, radius * cells.resolution(), cells.to_world(start.x, start.y),
                         cells.to_world(goal.x, goal.y), reason);
  if (why != nullptr) *why = reason;
  return path;
}

/// In cells; NaN without a path.
double solved_length(const Occupancy& cells, double radius, const TPoint2D& start,
                     const TPoint2D& goal) {
  const auto path = solve(cells, radius, start, goal);
  return path ? path->length / cells.resolution() : std::nan("");
}

void occupy(Occupancy& cells, int x0, int y0, int x1, int y1) {
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) cells.set_occupied(x, y, true);
}

TEST(DiscPath, IsTheStraightLineIfThatIsFree) {
  const auto path = solve(empty_cells(20, 20), 2, {2, 3}, {17, 11});
  ASSERT_TRUE(path.has_value());
  EXPECT_TRUE(path->arcs.empty());
  EXPECT_NEAR(path->length, 17 * kCellSize, 1e-15);  // 15 by 8
}

TEST(DiscPath, HasLengthZeroFromAPointToItself) {
  EXPECT_EQ(solved_length(empty_cells(9, 9), 2, {4, 5}, {4, 5}), 0);
}

TEST(DiscPath, RoundsTheCornersOfABlock) {
  // A block of 20 x 20 cells between start and goal, both 50 from its center: tangent, arc, side,
  // arc, tangent.
  Occupancy cells = empty_cells(120, 120);
  occupy(cells, 50, 50, 70, 70);
  constexpr double kRadius = 7.3;
  const double r = kRadius - kContact / kCellSize;
  const double to_corner = std::hypot(40, 10);
  const double turn = std::atan2(10, 40) + std::asin(r / to_corner);
  const double expected = 2 * (std::sqrt(to_corner * to_corner - r * r) + r * turn) + 20;
  const auto path = solve(cells, kRadius, {10, 60}, {110, 60});
  ASSERT_TRUE(path.has_value());
  EXPECT_NEAR(path->length / kCellSize, expected, 1e-12 * expected);
  ASSERT_EQ(path->arcs.size(), 2U);
  EXPECT_NEAR(path->arcs[0].sweep, turn, 1e-12);
  EXPECT_NEAR(path->arcs[1].sweep, turn, 1e-12);
}

TEST(DiscPath, OfASmallDiscIsTheAnyAngleOptimum) {
  // From (0.5, 1.5) over the corners (2, 2) and (3, 2): 2 |(1.5, 0.5)| + 1.
  const Occupancy block = occupancy_of({"......", "..#...", "......"});
  EXPECT_NEAR(solved_length(block, 1e-5, {0.5, 1.5}, {4.5, 1.5}), 2 * std::hypot(1.5, 0.5) + 1,
              1e-4);
  EXPECT_NEAR(solved_length(block, 0, {0.5, 1.5}, {4.5, 1.5}), 2 * std::hypot(1.5, 0.5) + 1, 1e-5)
      << "a point";
  // Through a slit: (0.5, 0.5), (2, 2), (3, 2), (4.5, 0.5).
  const Occupancy slit = occupancy_of({"..#..", "..#..", ".....", "..#..", "..#.."});
  EXPECT_NEAR(solved_length(slit, 1e-5, {0.5, 0.5}, {4.5, 0.5}), 2 * std::hypot(1.5, 1.5) + 1,
              1e-4);
  // A zigzag between two walls: the corners (2, 4), (3, 4), (5, 1), (6, 1), whose middle leg goes
  // from one to the other side.
  const Occupancy zigzag =
      occupancy_of({".....#..", "..#..#..", "..#..#..", "..#..#..", "..#....."});
  const double expected = std::hypot(1.5, 3.5) + 1 + std::hypot(2, 3) + 1 + std::hypot(1.5, 3.5);
  EXPECT_NEAR(solved_length(zigzag, 1e-5, {0.5, 0.5}, {7.5, 4.5}), expected, 1e-4);
}

TEST(DiscPath, DoesNotPassBetweenCellsThatTouchAtACorner) {
  for (const double radius : {0.0, 1e-5})
    EXPECT_FALSE(solve(occupancy_of({".#", "#."}), radius, {0.5, 1.5}, {1.5, 0.5}).has_value());
}

TEST(DiscPath, SaysWhyThereIsNone) {
  std::string reason;
  const Occupancy parted = occupancy_of({"..#..", "..#..", "..#.."});
  EXPECT_FALSE(solve(parted, 0.4, {1, 1}, {4, 1}, &reason).has_value());
  EXPECT_EQ(reason, "no path from start to goal is wide enough for the robot");
  EXPECT_FALSE(solve(parted, 0.6, {0.5, 1}, {4, 1}, &reason).has_value());
  EXPECT_EQ(reason, "start is closer to an obstacle than the robot's radius");
  EXPECT_FALSE(solve(parted, 0.6, {1, 1}, {2.5, 1}, &reason).has_value());
  EXPECT_EQ(reason, "goal is closer to an obstacle than the robot's radius");
  EXPECT_FALSE(solve(parted, 0.6, {1, 1}, {9, 1}, &reason).has_value());
}

TEST(DiscPath, PassesBetweenWallsExactlyAsFarApartAsTheDiameter) {
  // The center moves along y = 1 under the ceiling, around its end at (7, 2), up to (8.5, 4): all
  // limiting rays of its window in the passage are horizontal.
  Occupancy cells = empty_cells(10, 8);
  occupy(cells, 0, 2, 7, 8);
  const double r = 1 - kContact / kCellSize;
  const TPoint2D start(1.5, 1), goal(8.5, 4);
  const double from = std::hypot(5.5, 1), to = std::hypot(1.5, 2);  // distances from the corner
  const double arriving = std::atan2(1, 5.5) - std::asin(r / from);
  const double leaving = std::atan2(2, 1.5) + std::asin(r / to);
  const double expected =
      std::sqrt(from * from - r * r) + r * (leaving - arriving) + std::sqrt(to * to - r * r);
  EXPECT_NEAR(solved_length(cells, 1, start, goal), expected, 1e-12 * expected);
  EXPECT_NEAR(solved_length(cells, 1, goal, start), expected, 1e-12 * expected);
}

TEST(DiscPath, IsPlannedForTheRadiusOfCollisionChecking) {
  // A door of 4 cells. In cells of 2 r / 4 it is exactly as wide as the disc; it is open to
  // kContact less on each side, and closed to more.
  constexpr double kRadius = 0.1;  // m
  const auto is_open = [](double missing) {
    Occupancy cells(20, 12, (2 * kRadius - missing) / 4, TPoint2D(0, 0));
    occupy(cells, 9, 0, 11, 4);
    occupy(cells, 9, 8, 11, 12);
    std::string reason;
    return shortest_disc_path(cells, kRadius, cells.to_world(4, 5.5), cells.to_world(16, 6.5),
                              reason)
        .has_value();
  };
  EXPECT_TRUE(is_open(0));
  EXPECT_TRUE(is_open(1.9 * kContact));
  EXPECT_FALSE(is_open(2.1 * kContact));
}

TEST(DiscPath, PassesADoorOfItsDiameterByArcsOfAHundredMillionthOfARadian) {
  // In a door of 4 cells for a radius of 2 (0.1 m in cells of 0.05 m), arcs about both sides are as
  // short as the tolerance of collision checking allows: their limiting rays all but coincide.
  Occupancy cells = empty_cells(24, 16);
  occupy(cells, 11, 0, 12, 5);
  occupy(cells, 11, 9, 12, 16);
  for (int y = 2; y <= 14; ++y)
    for (const double goal_y : {3.0, 7.0, 7.25, 11.0}) {
      const TPoint2D start(3, y), goal(21, goal_y);
      const double expected = tangent_graph_length(cells, 2 - kContact / kCellSize, start, goal);
      ASSERT_NEAR(solved_length(cells, 2, start, goal), expected, 1e-12 * expected)
          << y << ", " << goal_y;
    }
}

TEST(DiscPath, KeepsToArcsWiderThanManyRows) {
  // Straight up along a wall, in contact, two quarter circles of 100 cells about its corners
  // (200, 300) and (202, 300), and straight down.
  Occupancy cells = empty_cells(402, 520);
  occupy(cells, 200, 0, 202, 300);
  constexpr double kRadius = 100;
  const double r = kRadius - kContact / kCellSize;
  const double to_corner = std::hypot(150, kRadius);
  const double leg = std::sqrt(to_corner * to_corner - r * r);
  const double turn = std::atan2(150, kRadius) + std::asin(r / to_corner);
  const double expected = 2 * (leg + r * turn) + 2;
  EXPECT_NEAR(solved_length(cells, kRadius, {100, 150}, {302, 150}), expected, 1e-12 * expected);
}

TEST(DiscPath, DoesNotDependOnThePositionInAWideMap) {
  // Farther right than 16 bits can count.
  constexpr int kFar = 70'000;
  const auto solve_at = [](int x) {
    Occupancy cells = empty_cells(kFar + 40, 12);
    occupy(cells, x + 15, 3, x + 20, 9);
    return solved_length(cells, 1.3, {x + 5.0, 5.0}, {x + 30.0, 6.5});
  };
  EXPECT_NEAR(solve_at(kFar), solve_at(0), 1e-9);
  EXPECT_GT(solve_at(0), std::hypot(25, 1.5) + 0.1);
}

TEST(DiscPathPolyline, OfAnArcBetweenTwoContactsHasChordsShortEnoughForBoth) {
  // A turn in a passage of exactly the diameter: chords outside the arc come closer to the other
  // wall than the radius, by less than collision checking tolerates.
  Occupancy cells = empty_cells(12, 12);
  occupy(cells, 0, 0, 12, 2);
  occupy(cells, 10, 0, 12, 12);
  occupy(cells, 0, 6, 6, 12);
  const auto path = solve(cells, 2, {2, 4}, {8, 10});
  ASSERT_TRUE(path.has_value());
  const Path points = to_polyline(*path, cells);
  EXPECT_LE(length(points), path->length * (1 + 1e-6));
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_TRUE(is_far_from_occupied(cells, cells.to_cells(points[i - 1]),
                                     cells.to_cells(points[i]), 2 - kContact / kCellSize));
}

}  // namespace
}  // namespace slalom
