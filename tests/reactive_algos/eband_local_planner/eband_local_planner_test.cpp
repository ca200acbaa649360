// SPDX-License-Identifier: BSD-3-Clause
#include "eband_local_planner/eband_local_planner.h"
#include "observations.h"

#include <gtest/gtest.h>

namespace eband_local_planner {
namespace {

using namespace reactive;

Twist decide(const std::vector<Wall>& walls, const Point& goal, const Twist& now = {},
             const Robot& robot = {}) {
  EbandLocalPlanner method({}, robot);
  method.reset({goal, 0.2, 0.1, 1});
  return method.step(observe(walls, goal, now));
}

/// The observation of a robot at (0, y) that looks along x, of a wall at x = 2 between y = -1
/// and 1.
Observation before_wall(double y, const Point& goal) {
  Observation observation = observe({{2, -1 - y, 2, 1 - y}}, {goal.x, goal.y - y});
  observation.pose.y = y;
  return observation;
}

TEST(EbandLocalPlanner, MovesStraightToAGoalInFreeSpace) {
  const Twist twist = decide({}, {5, 0}, {1, 0});
  // The largest bubble has a radius of ln(252) / 10 m: 2 * 0.7 of it times 1 m/s.
  EXPECT_NEAR(twist.v, 1.4 * 0.5529, 1e-3);
  EXPECT_NEAR(twist.w, 0, 0.05);
}

TEST(EbandLocalPlanner, PlansAroundWhatItHasNotSeenWithAKnownMap) {
  Parameters parameters;
  EXPECT_FALSE(EbandLocalPlanner(parameters, {}).uses_map());
  parameters.map = reactive::PathMap::Known;
  EbandLocalPlanner method(parameters, {});
  EXPECT_TRUE(method.uses_map());
  // A wall at x = 3 from y = -3 to 6, which no scan shows.
  KnownMap map = {0.1, {-2, -8}, 100, 160, std::vector<std::uint8_t>(std::size_t{100} * 160)};
  for (std::size_t y = 50; y < 140; ++y) map.cells[y * 100 + 50] = 1;
  method.set_map(map);
  const Point goal = {6, 0};
  method.reset({goal, 0.2, 0.1, 1});
  EXPECT_NEAR(decide({}, goal).w, 0, 0.05);
  EXPECT_LT(method.step(observe({}, goal)).w, -0.5) << "to the closer end";
}

TEST(EbandLocalPlanner, AlsoAvoidsWhatTheKnownMapLacks) {
  Parameters parameters;
  parameters.map = reactive::PathMap::Known;
  EbandLocalPlanner method(parameters, {});
  method.set_map({0.1, {-2, -8}, 100, 160, std::vector<std::uint8_t>(std::size_t{100} * 160)});
  const Point goal = {5, 0};
  method.reset({goal, 0.2, 0.1, 1});
  EXPECT_GT(method.step(observe({{1.2, -4, 1.2, 0.3}}, goal)).w, 0);
}

TEST(EbandLocalPlanner, IsWithinTheLimitsOfTheRobot) {
  Robot slow;
  slow.max_v = 0.05;
  slow.max_w = 0.3;
  EXPECT_EQ(decide({}, {5, 0}, {}, slow).v, 0.05) << "below min_vel_lin";
  EXPECT_EQ(decide({}, {0, 5}, {}, slow).w, 0.3);
}

TEST(EbandLocalPlanner, IsSlowerBetweenWalls) {
  // 0.54 m from both walls, of which the map, bilinear on cells of 0.05 m, is 0.025 m short in the
  // middle; a radius of 0.25 m and a padding of 0.05 m.
  const std::vector<Wall> corridor = {{-6, 0.54, 8, 0.54}, {-6, -0.54, 8, -0.54}};
  EXPECT_NEAR(decide(corridor, {5, 0}, {1, 0}).v, 1.4 * (0.515 - 0.3), 0.01);
}

TEST(EbandLocalPlanner, RotatesInPlaceToAGoalBehind) {
  const Twist twist = decide({}, {-3, 0.5});
  EXPECT_EQ(twist.v, 0);
  EXPECT_GT(twist.w, 1);
  const Twist moving = decide({}, {-3, 0.5}, {1, 0.5});
  EXPECT_EQ(moving.v, 0);
  EXPECT_NEAR(moving.w, 0.45, 1e-12) << "brakes on its arc first";
}

TEST(EbandLocalPlanner, TurnsTowardsTheOpenEndOfAWall) {
  EXPECT_GT(decide({{1.2, -4, 1.2, 0.3}}, {5, 0}).w, 0);
  EXPECT_LT(decide({{1.2, -0.3, 1.2, 4}}, {5, 0}).w, 0);
}

TEST(EbandLocalPlanner, RotatesWhereThereIsNoPath) {
  EXPECT_EQ(decide({{0.5, -4, 0.5, 4}, {-4, 0.4, 4, 0.4}, {-4, -0.4, 4, -0.4}}, {5, 0}).v, 0);
}

TEST(EbandLocalPlanner, StaysOnItsSideOfAnObstacleUntilANewPathIsDue) {
  const Point goal{4, 0.2};
  const auto turn_after_move = [&](double planner_frequency) {
    Parameters parameters;
    parameters.planner_frequency = planner_frequency;
    EbandLocalPlanner method(parameters, {});
    method.reset({goal, 0.2, 0.1, 1});
    EXPECT_GT(method.step(before_wall(0, goal)).w, 0) << "the left end is on the shorter path";
    return method.step(before_wall(-0.5, goal)).w;
  };
  EXPECT_GT(turn_after_move(0), 0);
  EXPECT_LT(turn_after_move(10), 0);
}

}  // namespace
}  // namespace eband_local_planner
