// SPDX-License-Identifier: BSD-3-Clause
#include "disc_problems.h"
#include "reference_worlds.h"
#include "tangent_graph.h"

#include <slalom/core/random.h>
#include <slalom/references/exact_shortest.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <queue>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

std::optional<ShortestPath> search(const World& world, double radius, std::string& reason) {
  return exact_shortest_path(problem_of(world, radius), reason);
}

TEST(ExactShortest, StraightLineIsCertifiedExactly) {
  const World world = empty_world(10, {1, 1}, {9, 7});
  std::string reason;
  const auto best = search(world, 0.25, reason);
  ASSERT_TRUE(best.has_value()) << reason;
  EXPECT_NEAR(best->length, 10, 1e-12);  // 8 by 6
  EXPECT_EQ(best->certificate.lower_bound, best->certificate.upper_bound);
}

TEST(ExactShortest, BothBoundsAreTheOptimumAroundASquare) {
  // A 2 m square centered between start and goal, 10 m apart; the robot has r = 0.5 m. The shortest
  // path: a tangent to the circle of radius r around a corner, an arc, the straight side, and the
  // same again.
  const double r = 0.5, half = 1, reach = 5;
  Primitives obstacles;
  obstacles.polygons.push_back({{{5, 5}, {7, 5}, {7, 7}, {5, 7}}});
  const World world(Scenario::continuous("square", {0, 0, 12, 12}, obstacles, {1, 6, 0}, {11, 6}),
                    0.05);
  // Start to the corner: (reach - half, half) away. The occupancy's squares touch the polygon from
  // outside, so the obstacle is one cell larger on each side where its border lies on a cell's
  // border.
  const double grown = half + 0.05;
  const double dx = reach - grown, dy = grown;
  const double to_corner = std::hypot(dx, dy);
  const double tangent = std::sqrt(to_corner * to_corner - r * r);
  const double angle = std::atan2(dy, dx) + std::asin(r / to_corner);  // of the tangent to the side
  const double optimum = 2 * (tangent + r * angle) + 2 * grown;
  std::string reason;
  const auto best = search(world, r, reason);
  ASSERT_TRUE(best.has_value()) << reason;
  // Planned for r - 1e-9 m, as collisions are checked: shorter by that times the angle turned.
  EXPECT_NEAR(best->certificate.lower_bound, optimum, 1e-8);
  EXPECT_NEAR(best->certificate.upper_bound, optimum, 1e-8);
  EXPECT_EQ(best->length, best->certificate.upper_bound);
  EXPECT_LE(length(best->path), best->length * (1 + 1e-6));
  EXPECT_TRUE(is_free(world, best->path, r));
}

TEST(ExactShortest, GivesTheReasonWhenThereIsNoPath) {
  std::string reason;
  const World crowded = walled_world(10, 0.3);  // a gap of 0.3 m
  EXPECT_FALSE(search(crowded, 0.25, reason).has_value());
  EXPECT_EQ(reason, "no path from start to goal is wide enough for the robot");
  const World near_wall = empty_world(10, {0.1, 5}, {9, 5});
  EXPECT_FALSE(search(near_wall, 0.25, reason).has_value());
  EXPECT_EQ(reason, "start is closer to an obstacle than the robot's radius");
  const World goal_near_wall = empty_world(10, {5, 5}, {5, 9.9});
  EXPECT_FALSE(search(goal_near_wall, 0.25, reason).has_value());
  EXPECT_EQ(reason, "goal is closer to an obstacle than the robot's radius");
}

TEST(ExactShortest, FindsPassagesThatAreJustWideEnough) {
  std::string reason;
  EXPECT_TRUE(search(walled_world(10, 0.8), 0.25, reason).has_value()) << reason;
  EXPECT_FALSE(search(walled_world(10, 0.4), 0.25, reason).has_value());
}

/// Length of the best path on a lattice with many neighbors whose segments are all free in the
/// exact model: an upper bound of L* that is independent of the search under test.
double lattice_length(const World& world, double radius, int per_meter) {
  const Bounds bounds = world.scenario().bounds();
  const int size_x = static_cast<int>(bounds.width() * per_meter) + 1;
  const int size_y = static_cast<int>(bounds.height() * per_meter) + 1;
  const auto point = [&](int i) {
    const int column = i % size_x, row = i / size_x;
    return TPoint2D(bounds.x_min + column / static_cast<double>(per_meter),
                    bounds.y_min + row / static_cast<double>(per_meter));
  };
  const auto nearest = [&](const TPoint2D& p) {
    return static_cast<int>(std::lround((p.y - bounds.y_min) * per_meter)) * size_x +
           static_cast<int>(std::lround((p.x - bounds.x_min) * per_meter));
  };
  const PlanningProblem problem = problem_of(world, radius);
  const int start = nearest(problem.start), goal = nearest(problem.goal);
  std::vector<double> best(static_cast<std::size_t>(size_x) * size_y,
                           std::numeric_limits<double>::infinity());
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>>
      queue;
  best[start] = 0;
  queue.emplace(0, start);
  while (!queue.empty()) {
    const auto [so_far, at] = queue.top();
    queue.pop();
    if (at == goal) return so_far;
    if (so_far > best[at]) continue;
    constexpr int kReach = 4;
    for (int dy = -kReach; dy <= kReach; ++dy)
      for (int dx = -kReach; dx <= kReach; ++dx) {
        const int x = at % size_x + dx, y = at / size_x + dy;
        if (x < 0 || y < 0 || x >= size_x || y >= size_y) continue;
        const int next = y * size_x + x;
        const double total = so_far + length({point(at), point(next)});
        if (total >= best[next] || !is_free(world, {point(at), point(next)}, radius)) continue;
        best[next] = total;
        queue.emplace(total, next);
      }
  }
  return std::numeric_limits<double>::infinity();
}

#if defined(SLALOM_SANITIZE)
constexpr int kWorlds = 100, kRandomGrids = 100;
#else
constexpr int kWorlds = 300, kRandomGrids = 500;
#endif

TEST(ExactShortest, IsNeverLongerThanALatticeSearchInManyWorlds) {
  // Not a multiple of half a cell: no passage has exactly the width of the robot, where the lattice
  // has no free point.
  constexpr double kRadius = 0.16;
  RandomEngine engine(5);
  int solved = 0;
  for (int trial = 0; trial < kWorlds; ++trial) {
    const World world = random_world(engine, 3, uniform_int(engine, 1, 6));
    std::string reason;
    const auto best = search(world, kRadius, reason);
    const double lattice = lattice_length(world, kRadius, 8);
    if (!best) {
      EXPECT_FALSE(std::isfinite(lattice)) << trial << ": " << reason;
      continue;
    }
    ++solved;
    EXPECT_TRUE(is_free(world, best->path, kRadius)) << trial;
    EXPECT_LE(best->certificate.upper_bound, lattice + 1e-9) << trial;
  }
  EXPECT_GT(solved, kWorlds / 3);
}

/// The cells of a random problem as a world; 1/16 m is exact in the single precision of grids, so
/// passages and contacts of exact multiples of cells remain exact.
constexpr float kExactCell = 0.0625F;  // m

World world_of(const DiscProblem& problem) {
  const Occupancy& cells = problem.cells;
  mrpt::maps::COccupancyGridMap2D map(0, kExactCell * static_cast<float>(cells.size_x()), 0,
                                      kExactCell * static_cast<float>(cells.size_y()), kExactCell);
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x) map.setCell(x, y, cells.occupied(x, y) ? 0.0F : 1.0F);
  const double cell = kExactCell;
  return World(Scenario::grid("random", map, {problem.start.x * cell, problem.start.y * cell, 0},
                              {problem.goal.x * cell, problem.goal.y * cell}),
               cell);
}

/// Whether the disc touches something at start or goal, to rounding errors.
bool touches(const DiscProblem& problem) {
  return !is_far_from_occupied(problem.cells, problem.start, problem.start,
                               problem.radius + 1e-6) ||
         !is_far_from_occupied(problem.cells, problem.goal, problem.goal, problem.radius + 1e-6);
}

TEST(ExactShortest, BoundsMeetAtTheOptimumOfAnyGridOrNoPathIsProved) {
  // Among them doors of exactly the robot's diameter, and starts in contact.
  RandomEngine engine(6);
  int solved = 0, touching = 0, none = 0;
  for (int trial = 0; trial < kRandomGrids; ++trial) {
    const DiscProblem problem = random_problem(engine);
    const World world = world_of(problem);
    const double radius = problem.radius * kExactCell;
    const double optimum =
        kExactCell * tangent_graph_length(problem.cells, problem.radius - kContact / kExactCell,
                                          problem.start, problem.goal);
    std::string reason;
    const auto best = search(world, radius, reason);
    ASSERT_EQ(best.has_value(), std::isfinite(optimum)) << trial << ": " << reason;
    if (!best) {
      ++none;
      continue;
    }
    ++solved;
    touching += touches(problem) ? 1 : 0;
    ASSERT_LE(best->certificate.gap(), 1e-9) << trial;
    ASSERT_NEAR(best->certificate.lower_bound, optimum, 1e-9 * optimum) << trial;
    ASSERT_NEAR(best->certificate.upper_bound, optimum, 1e-9 * optimum) << trial;
    ASSERT_TRUE(is_free(world, best->path, radius)) << trial;
    ASSERT_GE(length(best->path), optimum * (1 - 1e-9)) << trial;
    ASSERT_LE(length(best->path), optimum * (1 + 1e-6)) << trial;
  }
  EXPECT_GT(solved, kRandomGrids / 2);
  EXPECT_GT(touching, kRandomGrids / 4);
  EXPECT_GT(none, kRandomGrids / 20);
}

}  // namespace
}  // namespace slalom
