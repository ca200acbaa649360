// SPDX-License-Identifier: BSD-3-Clause
#include "common/costmap.h"
#include "common/global_planner.h"
#include "common/rolling_memory.h"
#include "observations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace reactive {
namespace {

constexpr Inflation kInflation = {0.165, 0.3, 10};

TEST(Inflation, HasTheCostsOfCostmap2d) {
  EXPECT_EQ(kInflation.cost(0), 254);
  EXPECT_EQ(kInflation.cost(0.05), 253);
  EXPECT_EQ(kInflation.cost(0.165), 253);
  EXPECT_EQ(kInflation.cost(0.2), 177);   // 252 exp(-0.35) = 177.6
  EXPECT_EQ(kInflation.cost(0.265), 92);  // 252 / e = 92.7
  EXPECT_EQ(kInflation.cost(0.3), 65);    // 252 exp(-1.35) = 65.3
  EXPECT_EQ(kInflation.cost(0.301), 0);
}

TEST(Costmap, HasTheCostOfTheDistanceBetweenCellCenters) {
  Costmap map(2, 0.05, kInflation);
  const std::vector<Point> points = {{0.31, 0.22}, {-0.41, -0.71}, {0.51, 0.32}};
  map.build({0.11, -0.03}, points);
  const ClearanceMap& grid = map.clearance();
  int costly = 0;
  for (int y = 0; y < grid.side(); ++y)
    for (int x = 0; x < grid.side(); ++x) {
      double closest = HUGE_VAL;
      for (const Point& p : points) {
        int px = 0, py = 0;
        ASSERT_TRUE(grid.cell_at(p, px, py));
        closest = std::min(closest, 0.05 * std::hypot(px - x, py - y));
      }
      // The table has one entry per mm.
      const int low = kInflation.cost(closest + 5.1e-4), high = kInflation.cost(closest - 5.1e-4);
      const int cost = map.cost(x, y);
      ASSERT_GE(cost, closest == 0 ? 254 : low) << x << ' ' << y;
      ASSERT_LE(cost, closest == 0 ? 254 : high) << x << ' ' << y;
      ASSERT_EQ(map.cost(grid.center_of(x, y)), cost);
      costly += cost > 0 ? 1 : 0;
    }
  EXPECT_GT(costly, 250) << "three discs of 0.3 m, two of them overlapping";
  EXPECT_EQ(map.cost({5, 0}), Inflation::kFree) << "outside";
}

/// An 8 m x 8 m room around the origin, unknown but for these points.
Costmap room(const std::vector<Point>& points) {
  Costmap map(4, 0.05, kInflation);
  map.build({0, 0}, points);
  return map;
}

void add_wall(double x, double low, double high, std::vector<Point>& points) {
  for (double y = low; y < high; y += 0.05) points.push_back({x, y});
}

double length_of(const std::vector<Point>& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += distance(path[i - 1], path[i]);
  return sum;
}

TEST(GlobalPlanner, PlansThroughUnseenCellsToTheGoal) {
  GlobalPlanner planner;
  const std::vector<Point> path = planner.plan(room({}), {-3, 0}, {3, 0});
  ASSERT_FALSE(path.empty());
  EXPECT_LT(distance(path.front(), {-3, 0}), 0.05);
  EXPECT_EQ(path.back().x, 3);
  EXPECT_NEAR(length_of(path), 6, 0.1);
}

TEST(GlobalPlanner, PrefersALongerPathAwayFromObstacles) {
  // The passage straight ahead is 0.55 m wide: in its middle a cell costs 50 + 0.8 * 86 (at
  // 0.275 m) instead of 50, for about 1 m. The other, free of costs, is 0.4 m longer at most.
  std::vector<Point> points;
  for (double x = -0.5; x < 0.5; x += 0.05) {
    points.push_back({x, -0.275});
    add_wall(x, 0.275, 0.5, points);
  }
  GlobalPlanner planner;
  double highest = 0;
  for (const Point& p : planner.plan(room(points), {-2, 0}, {2, 0}))
    highest = std::max(highest, std::abs(p.y));
  EXPECT_GT(highest, 0.5) << "around";
  // The straight passage is the shortest if the clearance has no cost.
  Costmap steep(4, 0.05, {0.165, 0.3, 1000});
  steep.build({0, 0}, points);
  for (const Point& p : planner.plan(steep, {-2, 0}, {2, 0})) EXPECT_LT(std::abs(p.y), 0.2);
}

TEST(CostToGo, IsTheLeastSumOfTheCostsOfACostmap) {
  // Against relaxation of all edges until nothing changes (Bellman and Ford), in a random map.
  std::vector<Point> points;
  for (int i = 0; i < 25; ++i) points.push_back({0.9 * std::sin(7.1 * i), 0.9 * std::cos(4.7 * i)});
  Costmap map(1, 0.05, {0.06, 0.3, 10});
  map.build({0, 0}, points);
  const ClearanceMap& grid = map.clearance();
  const int side = grid.side();
  const Point start = grid.center_of(2, 3), goal = grid.center_of(36, 35);
  const auto weight = [&](int x, int y) {
    const int cost = map.cost(x, y);
    // Inscribed cells around the start are open, at 20 times the cost of a free cell.
    if (cost >= 253) return distance(grid.center_of(x, y), start) < 0.3 ? 200 : 0;
    return 10 + 8 * cost / 50;
  };
  std::vector<double> least(grid.index(0, side), HUGE_VAL);
  least[grid.index(36, 35)] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 1; y < side - 1; ++y)
      for (int x = 1; x < side - 1; ++x)
        for (int k = 0; k < 9; ++k) {
          const int dx = k % 3 - 1, dy = k / 3 - 1, step = dx != 0 && dy != 0 ? 14 : 10;
          const double via = least[grid.index(x + dx, y + dy)] + step * weight(x, y);
          if (weight(x, y) == 0 || via >= least[grid.index(x, y)]) continue;
          least[grid.index(x, y)] = via;
          changed = true;
        }
  }
  CostToGo cost;
  cost.compute(map, goal, start);
  EXPECT_NEAR(cost.at(start), least[grid.index(2, 3)] / 100 * 0.05, 1e-9);
}

TEST(GlobalPlanner, HasNoPathThroughAnObstacle) {
  std::vector<Point> points;
  add_wall(1, -4, 4, points);
  GlobalPlanner planner;
  EXPECT_TRUE(planner.plan(room(points), {0, 0}, {3, 0}).empty());
}

TEST(GlobalPlanner, LeavesTheMapStraightToADistantGoal) {
  GlobalPlanner planner;
  const std::vector<Point> path = planner.plan(room({}), {0, 0}, {20, 0});
  ASSERT_GT(path.size(), 2u);
  EXPECT_GT(path[path.size() - 2].x, 3.8);
  EXPECT_EQ(path.back().x, 20);
}

TEST(GlobalCostmap, MovesWithTheRobotOverWhatWasSensed) {
  GlobalCostmap map(2, 0.05, kInflation);
  map.build({10, 0}, {{10.52, 0.02}, {5, 0}});
  EXPECT_EQ(map.costs().cost(Point{10.52, 0.02}), 254);
  EXPECT_EQ(map.costs().cost(Point{5, 0}), 0) << "outside";
}

TEST(GlobalCostmap, CoversTheKnownMapWithWhatWasSensed) {
  GlobalCostmap map(2, 0.05, kInflation);
  KnownMap known = {0.1, {-1, 2}, 80, 20, std::vector<std::uint8_t>(std::size_t{80} * 20)};
  known.cells[19 * 80 + 79] = 1;  // from (6.9, 3.9) to (7, 4)
  map.set_known(known);
  map.build({0, 3}, {{0.52, 3.02}});
  const auto cost = [&](double x, double y) { return map.costs().cost(Point{x, y}); };
  for (const double x : {6.925, 6.975})
    for (const double y : {3.925, 3.975}) EXPECT_EQ(cost(x, y), 254) << x << ' ' << y;
  EXPECT_EQ(cost(6.875, 3.925), 253);
  EXPECT_EQ(cost(0.52, 3.02), 254);
  EXPECT_EQ(cost(6, 3), 0);
  map.build({0, 3}, {});
  EXPECT_EQ(cost(0.52, 3.02), 0);
  EXPECT_EQ(cost(6.925, 3.925), 254);
}

TEST(RollingMemory, ForgetsWhatIsOutsideASquare) {
  RollingMemory memory(4, 0.05);
  memory.update({}, scan_of({{1, -3, 1, 3}}), {});
  const std::size_t all = memory.points().size();
  memory.clear_outside({0, 0}, 1.5);
  EXPECT_LT(memory.points().size(), all);
  EXPECT_GT(memory.points().size(), 50u);
  for (const Point& p : memory.points()) EXPECT_LE(std::abs(p.y), 1.5);
  memory.update({}, scan_of({{1, -3, 1, 3}}), {});
  EXPECT_EQ(memory.points().size(), all) << "marked again";
}

}  // namespace
}  // namespace reactive
