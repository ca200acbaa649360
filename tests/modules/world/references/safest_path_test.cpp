// SPDX-License-Identifier: BSD-3-Clause
#include "reference_worlds.h"

#include <slalom/references/safest_path.h>
#include <slalom/scenario/widest_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

TEST(SafestPath, FollowsTheCenterLineOfACorridor) {
  // A corridor 20 m by 3 m; start and goal off its center line.
  const World world(Scenario::continuous("corridor", {0, 0, 20, 3}, {}, {1, 0.5, 0}, {19, 0.5}),
                    0.05);
  std::string reason;
  const auto safest = safest_path(problem_of(world, 0.25), reason);
  ASSERT_TRUE(safest.has_value()) << reason;
  EXPECT_NEAR(safest->bottleneck, 0.5, 1e-9);  // at the start
  for (const auto& p : safest->path)
    if (p.x > 3 && p.x < 17) {
      EXPECT_NEAR(p.y, 1.5, 0.051);
    }
}

TEST(SafestPath, PrefersTheWiderOfTwoOpenings) {
  // A wall at x = 5 with openings of 1 m at y = 2 (on the straight line) and 2 m at y = 8.
  Primitives walls;
  for (const auto& [low, high] : {std::pair(0.0, 1.5), std::pair(2.5, 7.0), std::pair(9.0, 10.0)})
    walls.polygons.push_back({{{4.9, low}, {5.1, low}, {5.1, high}, {4.9, high}}});
  const World world(Scenario::continuous("two", {0, 0, 10, 10}, walls, {2, 2, 0}, {8, 2}), 0.05);
  std::string reason;
  const auto safest = safest_path(problem_of(world, 0.25), reason);
  ASSERT_TRUE(safest.has_value()) << reason;
  const auto crossing =
      std::find_if(safest->path.begin(), safest->path.end(), [](const auto& p) { return p.x > 5; });
  ASSERT_NE(crossing, safest->path.end());
  EXPECT_GT(crossing->y, 7);
}

/// The smallest d along the path, at cell centers and at the exact start and goal.
double bottleneck_of(const Path& path, const World& world) {
  double smallest = std::min(world.distance_field().clearance(path.front()),
                             world.distance_field().clearance(path.back()));
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const auto cell = world.occupancy().to_cells(path[i]);
    smallest = std::min(smallest, world.distance_field().at_center(static_cast<int>(cell.x),
                                                                   static_cast<int>(cell.y)));
  }
  return smallest;
}

TEST(SafestPath, HasTheWidestBottleneck) {
  RandomEngine engine(9);
  int solved = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const World world = random_world(engine, 8, 15);
    const PlanningProblem problem = problem_of(world, 0.2);
    const double widest = widest_bottleneck(world, problem.start, problem.goal);
    std::string reason;
    const auto safest = safest_path(problem, reason);
    ASSERT_EQ(safest.has_value(), widest >= 0.2) << reason;
    if (!safest) continue;
    ++solved;
    EXPECT_NEAR(safest->bottleneck, widest, 1e-9);
    EXPECT_NEAR(bottleneck_of(safest->path, world), widest, 1e-9);
    EXPECT_TRUE(is_free(world, safest->path, 0.2));
    for (std::size_t i = 1; i + 2 < safest->path.size(); ++i)
      EXPECT_LE(length({safest->path[i], safest->path[i + 1]}), 0.05 * std::sqrt(2.0) + 1e-9);
    EXPECT_EQ(safest->path.front(), problem.start);
    EXPECT_EQ(safest->path.back(), problem.goal);
  }
  EXPECT_GT(solved, 20);
}

TEST(SafestPath, TakesTheShorterOfTwoPassagesThatAreWideEnough) {
  // A block in a square; start and goal 0.4 m from the left and right walls. Both passages around
  // the block (2 m wide below, 6 m above) are wider: the bottleneck is 0.4 m for both, the path
  // below is shorter.
  Primitives block;
  block.polygons.push_back({{{4, 2}, {8, 2}, {8, 6}, {4, 6}}});
  const World world(
      Scenario::continuous("block", {0, 0, 12, 12}, block, {0.4, 3.5, 0}, {11.6, 3.5}), 0.05);
  std::string reason;
  const auto safest = safest_path(problem_of(world, 0.25), reason);
  ASSERT_TRUE(safest.has_value()) << reason;
  EXPECT_NEAR(safest->bottleneck, 0.4, 1e-9);
  for (const auto& p : safest->path) EXPECT_LT(p.y, 6);
}

TEST(SafestPath, GivesTheReasonWhenThereIsNoPath) {
  std::string reason;
  EXPECT_FALSE(safest_path(problem_of(empty_world(10, {0.1, 5}, {9, 5}), 0.25), reason));
  EXPECT_EQ(reason, "start is closer to an obstacle than the robot's radius");
  EXPECT_FALSE(safest_path(problem_of(empty_world(10, {1, 5}, {9, 9.9}), 0.25), reason));
  EXPECT_EQ(reason, "goal is closer to an obstacle than the robot's radius");
  EXPECT_FALSE(safest_path(problem_of(walled_world(10, 0.4), 0.25), reason));
  EXPECT_EQ(reason, "no path over cell centers is wide enough for the robot");
}

TEST(SafestPath, ConnectsStartAndGoalInOneCell) {
  const World world = empty_world(4, {2.01, 2.01}, {2.02, 2.03});
  std::string reason;
  const auto safest = safest_path(problem_of(world, 0.25), reason);
  ASSERT_TRUE(safest.has_value()) << reason;
  EXPECT_LT(length(safest->path), 0.2);
}

TEST(SafestPath, IsAsShortAsTheDiagramAllowsInAnEmptySquare) {
  // Both ends on the center line of a square: the path along it is straight.
  const World world = empty_world(10, {2, 5.025}, {8, 5.025});
  std::string reason;
  const auto safest = safest_path(problem_of(world, 0.25), reason);
  ASSERT_TRUE(safest.has_value()) << reason;
  EXPECT_LT(length(safest->path), 6 * 1.1);
}

}  // namespace
}  // namespace slalom
