// SPDX-License-Identifier: BSD-3-Clause
#include "common/cost_to_go.h"
#include "observations.h"
#include "one_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace reactive {
namespace {

CostToGo cost_to_goal(const ClearanceMap& map, const Point& goal, const Point& robot,
                      double clearance) {
  CostToGo result;
  result.compute(map, goal, robot, {clearance, clearance, 0}, 100);
  return result;
}

TEST(CostToGo, IsThePathLengthInFreeSpace) {
  ClearanceMap map(4, 0.05, 0.5);
  map.build({0, 0}, {});
  CostToGo cost = cost_to_goal(map, {3, 0.025}, {-3, 0}, 0.25);
  EXPECT_NEAR(cost.at({-3, 0.025}), 6, 0.05);
  // Also along a diagonal: a step counts as 1.4 cells instead of 1.414.
  EXPECT_NEAR(cost.at({0.025, -2.95}), 2.975 * 1.4, 0.06);
}

TEST(CostToGo, IsThatToTheClosestOfSeveralGoals) {
  ClearanceMap map(6, 0.05, 1);
  map.build({0, 0}, map_of({{1.5, -1, 1.5, 1}}).points());
  const std::vector<Point> goals = {{3.01, 0.02}, {-2.01, 1.02}, {40, 0}};
  CostToGo both;
  both.compute(map, goals, {0, 0}, {0.3, 0.5, 2}, 100);
  CostToGo first, second;
  first.compute(map, goals[0], {0, 0}, {0.3, 0.5, 2}, 100);
  second.compute(map, goals[1], {0, 0}, {0.3, 0.5, 2}, 100);
  // At cell centers, where nothing is interpolated.
  for (double x = -3.025; x < 4; x += 0.5)
    for (double y = -2.025; y < 2; y += 0.5)
      EXPECT_DOUBLE_EQ(both.at({x, y}), std::min(first.at({x, y}), second.at({x, y})));
}

TEST(CostToGo, LeadsAroundAWall) {
  const LocalMap map = map_of({{1.5, -1, 1.5, 1}});
  CostToGo cost = cost_to_goal(map.clearance(), {3, 0}, {0, 0}, 0.3);
  // Around an end at (1.5, 1) with 0.3 m clearance: not shorter than two straight lines via that
  // point.
  EXPECT_GT(cost.at({0, 0}), 2 * std::hypot(1.5, 1.0));
  EXPECT_LT(cost.at({0, 0}), 2 * std::hypot(1.5, 1.3) * 1.09 + 0.1);
  for (const Point& p : cost.path({0, 0}, 10)) EXPECT_GE(map.clearance().at(p), 0.29);
}

TEST(CostToGo, PassesOnlyDoorsThatAreWideEnough) {
  // A wall across the whole map with a door of 0.8 m.
  const LocalMap map = map_of({{1, -7.5, 1, -0.4}, {1, 0.4, 1, 7.5}});
  CostToGo narrow = cost_to_goal(map.clearance(), {2.5, 0}, {0, 0}, 0.35);
  EXPECT_TRUE(narrow.reached({0, 0}));
  EXPECT_LT(narrow.at({0, 0}), 3);
  CostToGo wide = cost_to_goal(map.clearance(), {2.5, 0}, {0, 0}, 0.45);
  EXPECT_TRUE(!wide.reached({0, 0}) || wide.at({0, 0}) > 6);
}

TEST(CostToGo, LeadsToTheBorderTowardsADistantGoal) {
  ClearanceMap map(2, 0.05, 0.5);
  map.build({0, 0}, {});
  CostToGo cost = cost_to_goal(map, {20, 0}, {0, 0}, 0.25);
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

/// A map with walls and posts, some of which touch.
ClearanceMap crowded_map(const Point& center, double seed) {
  std::vector<Point> points;
  for (int i = 0; i < 45; ++i) {
    const Point post = {center.x + 2.9 * std::sin(seed * i), center.y + 2.9 * std::cos(1.7 * i)};
    for (double a = 0; a < 6.28; a += 0.3)
      points.push_back({post.x + 0.12 * std::cos(a), post.y + 0.12 * std::sin(a)});
  }
  ClearanceMap map(3, 0.05, 0.6);
  map.build(center, points);
  return map;
}

/// Weight in tenths: 10 at `comfort`, 10 (1 + comfort_weight) at `clearance`, closed below that,
/// but 200 within 0.3 m of the robot.
int weight_of(const ClearanceMap& map, int x, int y, const Point& robot, const PathCosts& costs) {
  const double clearance = map.cell(x, y);
  if (clearance < costs.clearance) return distance(map.center_of(x, y), robot) < 0.3 ? 200 : 0;
  const double deficit = (costs.comfort - clearance) / (costs.comfort - costs.clearance);
  return 10 + static_cast<int>(costs.comfort_weight * std::max(0.0, deficit) * 10);
}

/// Dijkstra's algorithm without any order but that of costs, in the interior of the map: costs from
/// a goal in it, in hundredths of a cell by index; -1 where not reached.
std::vector<int> plain_dijkstra(const ClearanceMap& map, const Point& goal, const Point& robot,
                                const PathCosts& costs) {
  using Entry = std::pair<int, std::pair<int, int>>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<int> result(map.index(0, map.side()), -1);
  int gx = 0, gy = 0;
  map.cell_at(goal, gx, gy);
  queue.push({0, {gx, gy}});
  while (!queue.empty()) {
    const auto [cost, cell] = queue.top();
    const auto [x, y] = cell;
    queue.pop();
    if (std::min(x, y) < 1 || std::max(x, y) > map.side() - 2) continue;
    if (result[map.index(x, y)] >= 0) continue;
    result[map.index(x, y)] = cost;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int weight = weight_of(map, x + dx, y + dy, robot, costs);
        if (weight == 0 || (dx == 0 && dy == 0)) continue;
        queue.push({cost + (dx * dy != 0 ? 14 : 10) * weight, {x + dx, y + dy}});
      }
  }
  return result;
}

TEST(CostToGo, EqualsPlainDijkstraWithinItsReach) {
  const Point robot = {10.31, -4.87};
  const PathCosts costs = {0.15, 0.4, 2};
  constexpr double kReach = 1.1, kSlack = 0.8;
  int compared = 0, beyond = 0;
  for (const double seed : {1.0, 2.3, 3.1, 4.7, 5.9}) {
    const ClearanceMap map = crowded_map(robot, seed);
    const Point goal = {robot.x + 2.4, robot.y + std::sin(seed)};
    const std::vector<int> expected = plain_dijkstra(map, goal, robot, costs);
    CostToGo cost(kReach);
    cost.compute(map, goal, robot, costs, kSlack);
    const double limit = cost.at(robot) + kSlack - 0.15;  // a cell of interpolation
    for (int y = 1; y < map.side() - 1; ++y)
      for (int x = 1; x < map.side() - 1; ++x) {
        const Point p = map.center_of(x, y);
        const int hundredths = expected[map.index(x, y)];
        if (distance(p, robot) > kReach) continue;
        const double meters = hundredths * 0.05 / 100;
        if (hundredths < 0)
          ASSERT_FALSE(cost.reached(p)) << x << ' ' << y;
        else if (meters < limit)
          ASSERT_NEAR(cost.at(p), meters, 1e-9) << x << ' ' << y;
        else
          ASSERT_GE(cost.at(p), meters - 1e-9) << x << ' ' << y;
        (hundredths >= 0 && meters < limit ? compared : beyond) += 1;
      }
  }
  EXPECT_GT(compared, 2000);
  EXPECT_GT(beyond, 200);
}

TEST(CostToGo, HasTheSamePathsAsAWavefrontInAllDirections) {
  const Point robot = {-3.02, 7.7};
  const PathCosts costs = {0.15, 0.4, 2};
  constexpr double kLength = 1.5;
  for (const double seed : {1.0, 2.3, 3.1, 4.7, 5.9})
    for (const double bearing : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0})
      for (const double range : {1.8, 9.0}) {  // inside the map, beyond it
        const ClearanceMap map = crowded_map(robot, seed);
        const Point goal = {robot.x + range * std::cos(bearing),
                            robot.y + range * std::sin(bearing)};
        CostToGo directed(CostToGo::kPathReach * kLength), complete;
        directed.compute(map, goal, robot, costs);
        complete.compute(map, goal, robot, costs, 100);
        const auto path = directed.path(robot, kLength), expected = complete.path(robot, kLength);
        ASSERT_EQ(path.size(), expected.size()) << seed << ' ' << bearing << ' ' << range;
        for (std::size_t i = 0; i < path.size(); ++i) {
          ASSERT_EQ(path[i].x, expected[i].x) << seed << ' ' << bearing << ' ' << range;
          ASSERT_EQ(path[i].y, expected[i].y) << seed << ' ' << bearing << ' ' << range;
        }
      }
}

TEST(CostToGo, HasTheSameBitsWithEveryInstructionSet) {
  const ClearanceMap map = crowded_map({0, 0}, 2.3);
  CostToGo expected(1.2);
  expected.compute(map, {8, 3}, {0, 0}, {0.15, 0.4, 2});
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
    const slalom::testing::OneTarget target(left & -left);
    CostToGo cost(1.2);
    cost.compute(map, {8, 3}, {0, 0}, {0.15, 0.4, 2});
    for (double x = -1; x < 1; x += 0.03)
      for (double y = -1; y < 1; y += 0.03)
        ASSERT_EQ(cost.at({x, y}), expected.at({x, y})) << hwy::TargetName(left & -left);
  }
}

}  // namespace
}  // namespace reactive
