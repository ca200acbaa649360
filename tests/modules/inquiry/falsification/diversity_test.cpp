// SPDX-License-Identifier: BSD-3-Clause

#include "diversity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

constexpr double kCell = 0.02;  // m

/// A square of 1 m whose center is `ahead` m before the start and `aside` m to its left, in a task
/// that begins at (x, y) and goes into the direction `angle`.
Scenario square_in_task(double ahead, double aside, double x, double y, double angle) {
  const mrpt::math::TPose2D frame(x, y, angle);
  Polygon square;
  for (const auto& [dx, dy] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
    square.vertices.push_back(frame.composePoint({ahead + dx, aside + dy}));
  Primitives obstacles;
  obstacles.polygons = {square};
  // The heading of the start is not the direction of the task.
  return Scenario::continuous("square", {0, 0, 10, 10}, obstacles, {x, y, 1.3},
                              frame.composePoint({3.5, 0}));
}

double dissimilarity(const Scenario& a, const Scenario& b) {
  return ObstacleArea(a, kCell).dissimilarity(ObstacleArea(b, kCell));
}

TEST(Diversity, IsTheJaccardDistanceOfTheAreasOfObstaclesInTheFrameOfTheTask) {
  // Squares that are shifted by d overlap by (1 - d) of 1 + d m^2. Cells that an obstacle touches
  // are occupied, which makes each square larger by at most a cell on each side.
  const Scenario one = square_in_task(1.5, 0, 2, 5, 0);
  for (const double shift : {0.0, 0.25, 0.5, 0.8}) {
    const double expected = 1 - (1 - shift) / (1 + shift);
    const Scenario other = square_in_task(1.5, shift, 6, 3, 2.1);
    EXPECT_NEAR(dissimilarity(one, other), expected, 0.08) << shift;
    EXPECT_EQ(dissimilarity(one, other), dissimilarity(other, one));
  }
  EXPECT_EQ(dissimilarity(one, one), 0);
  EXPECT_EQ(dissimilarity(one, square_in_task(1.5, 2, 2, 5, 0)), 1);
}

TEST(Diversity, DoesNotCountTheBorderAndIsZeroWithoutObstacles) {
  const Scenario small = Scenario::continuous("empty", {0, 0, 4, 4}, {}, {1, 2, 0}, {3, 2});
  const Scenario large = Scenario::continuous("empty", {0, 0, 9, 9}, {}, {1, 2, 0}, {3, 2});
  EXPECT_EQ(dissimilarity(small, large), 0);
}

TEST(Diversity, CountsTheAreaThatMoversSweep) {
  const Scenario empty = Scenario::continuous("empty", {0, 0, 6, 6}, {}, {1, 3, 0}, {5, 3});
  const auto with_mover = [&](double x) {
    Mover mover;
    mover.id = "mover";
    mover.radius = 0.3;
    mover.waypoints = {{0, {x, 1}}, {4, {x, 5}}};
    return empty.with_movers({mover});
  };
  EXPECT_EQ(dissimilarity(with_mover(2), with_mover(2)), 0);
  EXPECT_EQ(dissimilarity(with_mover(2), with_mover(4)), 1);
  // Stadiums of 4 m x 0.6 m, shifted by a quarter of their width.
  const double stadium = 4 * 0.6 + M_PI * 0.09,
               lens = 4 * 0.45 + 2 * 0.09 * std::acos(0.25) - 0.075 * std::sqrt(0.36 - 0.0225);
  EXPECT_NEAR(dissimilarity(with_mover(2), with_mover(2.15)), 1 - lens / (2 * stadium - lens),
              0.02);
}

/// The area of a person is that of a mover on the straight lines of its route.
TEST(Diversity, CountsTheAreaThatPeopleSweep) {
  const Scenario empty = Scenario::continuous("empty", {0, 0, 6, 6}, {}, {1, 3, 0}, {5, 3});
  const Scenario moving =
      empty.with_movers({{"a", 0.3, {{0, {2, 1}}, {4, {2, 5}}, {6, {4, 5}}}, MoverEnd::Stop}});
  const auto with_person = [&](double x) {
    return empty.with_people({{"a", 0.3, 1, {x, 1}, {{x, 5}, {x + 2, 5}}}});
  };
  EXPECT_EQ(dissimilarity(with_person(2), moving), 0);
  EXPECT_GT(dissimilarity(with_person(3), moving), 0.5);
}

TEST(Diversity, OfAListIsTheMeanOfAllPairs) {
  const auto area = [](double aside) {
    return ObstacleArea(square_in_task(1.5, aside, 2, 5, 0), kCell);
  };
  EXPECT_FALSE(diversity({area(0)}));
  const double half = area(0).dissimilarity(area(0.5));
  EXPECT_NEAR(diversity({area(0), area(0.5), area(2)}).value(), (half + 1 + 1) / 3, 1e-12);
  EXPECT_TRUE(is_distinct(area(0.5), {area(0)}));            // 2/3
  EXPECT_FALSE(is_distinct(area(0.2), {area(2), area(0)}));  // 1/3
}

}  // namespace
}  // namespace slalom
