#include "common/clearance_map.h"
#include "common/cost_to_go.h"
#include "observations.h"

#include <gtest/gtest.h>

namespace reactive {
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

CostToGo cost_to_goal(const ClearanceMap& map, const Point& goal, const Point& robot,
                      double clearance) {
  CostToGo result;
  result.compute(map, goal, robot, {clearance, clearance, 0}, 100);
  return result;
}

TEST(CostToGo, IsThePathLengthInFreeSpace) {
  ClearanceMap map(4, 0.05, 0.5);
  map.build({0, 0}, {});
  const CostToGo cost = cost_to_goal(map, {3, 0.025}, {-3, 0}, 0.25);
  EXPECT_NEAR(cost.at({-3, 0.025}), 6, 0.05);
  // Also along a diagonal: a step counts as 1.4 cells instead of 1.414.
  EXPECT_NEAR(cost.at({0.025, -2.95}), 2.975 * 1.4, 0.06);
}

TEST(CostToGo, LeadsAroundAWall) {
  const LocalMap map = map_of({{1.5, -1, 1.5, 1}});
  const CostToGo cost = cost_to_goal(map.clearance(), {3, 0}, {0, 0}, 0.3);
  // Around an end at (1.5, 1) with 0.3 m clearance: not shorter than two straight lines via that
  // point.
  EXPECT_GT(cost.at({0, 0}), 2 * std::hypot(1.5, 1.0));
  EXPECT_LT(cost.at({0, 0}), 2 * std::hypot(1.5, 1.3) * 1.09 + 0.1);
  for (const Point& p : cost.path({0, 0}, 10)) EXPECT_GE(map.clearance().at(p), 0.29);
}

TEST(CostToGo, PassesOnlyDoorsThatAreWideEnough) {
  // A wall across the whole map with a door of 0.8 m.
  const LocalMap map = map_of({{1, -7.5, 1, -0.4}, {1, 0.4, 1, 7.5}});
  const CostToGo narrow = cost_to_goal(map.clearance(), {2.5, 0}, {0, 0}, 0.35);
  EXPECT_TRUE(narrow.reached({0, 0}));
  EXPECT_LT(narrow.at({0, 0}), 3);
  const CostToGo wide = cost_to_goal(map.clearance(), {2.5, 0}, {0, 0}, 0.45);
  EXPECT_TRUE(!wide.reached({0, 0}) || wide.at({0, 0}) > 6);
}

TEST(CostToGo, LeadsToTheBorderTowardsADistantGoal) {
  ClearanceMap map(2, 0.05, 0.5);
  map.build({0, 0}, {});
  const CostToGo cost = cost_to_goal(map, {20, 0}, {0, 0}, 0.25);
  const auto path = cost.path({0, 0}, 10);
  ASSERT_FALSE(path.empty());
  EXPECT_GT(path.back().x, 1.8);
  EXPECT_NEAR(path.back().y, 0, 0.5);
}

TEST(CostToGo, AClearanceCostLeadsThroughTheMiddle) {
  const LocalMap map = map_of({{-1, -0.9, 4, -0.9}, {-1, 0.9, 4, 0.9}});
  CostToGo cost;
  cost.compute(map.clearance(), {4, 0}, {0, 0.5}, {0.3, 0.85, 4}, 100);
  const auto path = cost.path({0, 0.5}, 3);
  ASSERT_GT(path.size(), 20U);
  EXPECT_LT(std::abs(path.back().y), 0.2);
}

TEST(LineIsFree, DetectsPostsBesideIt) {
  ClearanceMap map(4, 0.05, 0.8);
  map.build({0, 0}, {{1, 0.3}});
  EXPECT_TRUE(line_is_free(map, {0, 0}, {2, 0}, 0.27));
  EXPECT_FALSE(line_is_free(map, {0, 0}, {2, 0}, 0.33));
}

TEST(LocalPlanner, SelectsAVisibleGoal) {
  LocalMap map = map_of({});
  LocalPlanner planner({0.3, 0.5, 2}, 0.26);
  const Waypoint waypoint = planner.find(map, {0, 0, 0}, {2, 1}, 5);
  EXPECT_TRUE(waypoint.is_goal);
  EXPECT_DOUBLE_EQ(waypoint.position.x, 2);
}

TEST(LocalPlanner, SelectsTheEndOfABlockingWall) {
  LocalMap map = map_of({{1.5, -4, 1.5, 1}});
  LocalPlanner planner({0.3, 0.5, 2}, 0.26);
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
  LocalPlanner planner({0.3, 0.5, 2}, 0.26);
  const Waypoint waypoint = planner.find(map, {0, 0, 0}, {3, 0}, 5);
  EXPECT_FALSE(waypoint.reachable);
  EXPECT_DOUBLE_EQ(waypoint.position.x, 3);
}

}  // namespace
}  // namespace reactive
