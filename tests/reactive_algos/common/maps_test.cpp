// SPDX-License-Identifier: BSD-3-Clause
#include "common/clearance_map.h"
#include "common/cost_to_go.h"
#include "observations.h"
#include "one_target.h"

#include <gtest/gtest.h>

#include <cmath>

namespace reactive {

using slalom::testing::OneTarget;

namespace {

TEST(ClearanceMap, IsTheDistanceToTheClosestPoint) {
  ClearanceMap map(2, 0.05, 1.0);
  const std::vector<Point> points = {{0.31, 0.2}, {-0.4, -0.7}, {1.02, 0.77}};
  map.build({0.1, 0}, points);
  for (double x = -1; x < 1.2; x += 0.17)
    for (double y = -1; y < 1; y += 0.13) {
      double expected = 1.0;
      for (const Point& p : points) expected = std::min(expected, distance(p, {x, y}));
      // Bilinear on cells of 0.05 m: a cone is off by less than half a cell at its tip.
      EXPECT_NEAR(map.at({x, y}), expected, expected < 0.1 ? 0.036 : 0.012) << x << ' ' << y;
    }
}

TEST(ClearanceMap, IsLimitedToItsBandAlsoOutside) {
  ClearanceMap map(2, 0.05, 0.6);
  map.build({0, 0}, {{0, 0}});
  EXPECT_NEAR(map.at({1, 1}), 0.6, 1e-6);
  EXPECT_NEAR(map.at({50, 0}), 0.6, 1e-6);
}

TEST(ClearanceMap, HasTheSameBitsWithEveryInstructionSet) {
  ClearanceMap map(2, 0.05, 0.6);
  std::vector<Point> points;
  for (int i = 0; i < 60; ++i) points.push_back({2.1 * std::sin(i), 2.1 * std::cos(1.7 * i)});
  map.build({0.1, 0}, points);
  const std::vector<float> chosen = map.cells();
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
    const OneTarget target(left & -left);
    map.build({0.1, 0}, points);
    EXPECT_EQ(map.cells(), chosen) << hwy::TargetName(left & -left);
  }
}

TEST(ClearanceMap, HasTheSameValuesAtManyPositionsAsAtEach) {
  ClearanceMap map(2, 0.05, 0.6);
  map.build({0.1, 0}, {{0.31, 0.2}, {-0.4, -0.7}, {1.02, 0.77}, {-1.9, 1.9}});
  std::vector<double> x, y;  // also outside, at the border and where there is no number
  for (int i = 0; i < 1001; ++i) {
    x.push_back(i == 500 ? NAN : 2.2 * std::sin(i));
    y.push_back(2.2 * std::cos(1.7 * i));
  }
  x.resize(padded(1001));
  y.resize(padded(1001));
  std::vector<double> clearances(padded(1001));
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
    const OneTarget target(left & -left);
    map.at(x.data(), y.data(), 1001, clearances.data());
    for (std::size_t i = 0; i < 1001; ++i)
      ASSERT_EQ(clearances[i], map.at({x[i], y[i]})) << hwy::TargetName(left & -left) << ' ' << i;
  }
}

TEST(ClearanceBand, DoesNotChangeValuesBelowTheComfort) {
  const Robot robot;
  constexpr double kComfort = 0.3;
  ClearanceMap wide(2, 0.05, 1.5), narrow(2, 0.05, clearance_band(robot, 0.04, kComfort));
  std::vector<Point> points;
  for (int i = 0; i < 12; ++i) points.push_back({2.1 * std::sin(i), 2.1 * std::cos(1.7 * i)});
  wide.build({0, 0}, points);
  narrow.build({0, 0}, points);
  int below = 0;
  for (double x = -1.9; x < 1.9; x += 0.013)
    for (double y = -1.9; y < 1.9; y += 0.017) {
      const double expected = wide.at({x, y}), limit = robot.radius + kComfort;
      if (expected < limit)
        ASSERT_EQ(narrow.at({x, y}), expected);
      else
        ASSERT_GE(narrow.at({x, y}), limit);
      below += expected < limit ? 1 : 0;
    }
  EXPECT_GT(below, 1000);
}

TEST(LocalMap, HasAllThatIsSeenAndTheGoalAndNoMore) {
  // The robot at the origin; a wall 3 m ahead, the goal 5 m to the left.
  const Observation observation = observe({{3, -1, 3, 1}}, {0, 5});
  LocalMap map({15, 0.6}, {}), close({4, 0.6}, {});
  map.update(observation);
  close.update(observation);
  const auto at = [](const LocalMap& one, const Point& p) { return one.clearance().at(p); };
  EXPECT_NEAR(at(map, {2.8, 0}), 0.2, 0.02);
  int x = 0, y = 0;
  EXPECT_TRUE(map.clearance().cell_at({0, 6}, x, y)) << "1 m behind the goal";
  EXPECT_TRUE(map.clearance().cell_at({4, 0}, x, y));
  const double side = map.clearance().side() * map.clearance().resolution();
  EXPECT_LE(side, 5 + 1 + 2 * 1.6 + 3) << "a robot, a goal and what is around, in steps";
  EXPECT_NEAR(close.clearance().side() * close.clearance().resolution(), 8, 1e-9);
  for (double p = -3; p < 3.5; p += 0.21)
    EXPECT_NEAR(at(map, {p, 0.3 * p}), at(close, {p, 0.3 * p}), 1e-6) << p;
}

TEST(LineIsFree, DetectsPostsBesideIt) {
  ClearanceMap map(4, 0.05, 0.8);
  map.build({0, 0}, {{1, 0.3}});
  EXPECT_TRUE(line_is_free(map, {0, 0}, {2, 0}, 0.27));
  EXPECT_FALSE(line_is_free(map, {0, 0}, {2, 0}, 0.33));
}

TEST(LocalPlanner, SelectsAVisibleGoal) {
  LocalMap map = map_of({});
  LocalPlanner planner({0.3, 0.5, 2}, 0.26, 2);
  const Waypoint waypoint = planner.find(map, {0, 0, 0}, {2, 1}, 5);
  EXPECT_TRUE(waypoint.is_goal);
  EXPECT_DOUBLE_EQ(waypoint.position.x, 2);
}

TEST(LocalPlanner, SeesItsPathAlsoCloserToAWallThanPathsLead) {
  // 0.28 m beside a wall; paths keep 0.31 m, so that the line along the wall is not one of them.
  LocalMap map = map_of({{-3, -0.28, 6, -0.28}, {2, 0.5, 2, 5}});
  LocalPlanner planner({0.31, 0.5, 2}, 0.26, 2);
  const Waypoint waypoint = planner.find(map, {0, 0, 0}, {4, 0}, 5);
  EXPECT_GT(distance(waypoint.position, {0, 0}), 1);
}

TEST(LocalPlanner, SelectsTheEndOfABlockingWall) {
  LocalMap map = map_of({{1.5, -4, 1.5, 1}});
  LocalPlanner planner({0.3, 0.5, 2}, 0.26, 2);
  const Waypoint waypoint = planner.find(map, {0, 0, 0}, {3, 0}, 5);
  EXPECT_FALSE(waypoint.is_goal);
  EXPECT_GT(std::atan2(waypoint.position.y, waypoint.position.x), std::atan2(1.0, 1.5));
}

TEST(LocalPlanner, ReportsAnUnreachableGoal) {
  LocalMap map = map_of({{1, -1, 1, 1}, {-1, 1, 1, 1}, {-1, -1, 1, -1}});
  // The fourth side, observed after a rotation.
  Observation behind = observe({{1, -1, 1, 1}, {-1, 1, 1, 1}, {-1, -1, 1, -1}}, {});
  behind.pose.phi = M_PI;
  map.update(behind);
  LocalPlanner planner({0.3, 0.5, 2}, 0.26, 2);
  const Waypoint waypoint = planner.find(map, {0, 0, 0}, {3, 0}, 5);
  EXPECT_FALSE(waypoint.reachable);
  EXPECT_DOUBLE_EQ(waypoint.position.x, 3);
}

}  // namespace
}  // namespace reactive
