#include "reference_worlds.h"

#include <slalom/core/random.h>
#include <slalom/references/exact_shortest.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <queue>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

std::optional<ShortestPath> search(const World& world, double radius, double gap,
                                   std::string& reason) {
  return exact_shortest_path(problem_of(world, radius), gap, reason);
}

TEST(ExactShortest, StraightLineIsCertifiedExactly) {
  const World world = empty_world(10, {1, 1}, {9, 7});
  std::string reason;
  const auto best = search(world, 0.25, 0.01, reason);
  ASSERT_TRUE(best.has_value()) << reason;
  EXPECT_NEAR(best->length, 10, 1e-12);  // 8 by 6
  EXPECT_EQ(best->certificate.lower_bound, best->certificate.upper_bound);
}

TEST(ExactShortest, OptimumAroundASquareIsWithinTheCertificate) {
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
  const auto best = search(world, r, 0.005, reason);
  ASSERT_TRUE(best.has_value()) << reason;
  EXPECT_LE(best->certificate.lower_bound, optimum + 1e-9);
  EXPECT_GE(best->length, optimum - 1e-9);
  EXPECT_LE(best->length, optimum * 1.002);
  EXPECT_LE(best->certificate.gap(), 0.005);
  EXPECT_TRUE(is_free(world, best->path, r));
}

TEST(ExactShortest, GivesTheReasonWhenThereIsNoPath) {
  std::string reason;
  const World crowded = walled_world(10, 0.3);  // a gap of 0.3 m
  EXPECT_FALSE(search(crowded, 0.25, 0.01, reason).has_value());
  EXPECT_EQ(reason, "no path from start to goal is wide enough for the robot");
  const World near_wall = empty_world(10, {0.1, 5}, {9, 5});
  EXPECT_FALSE(search(near_wall, 0.25, 0.01, reason).has_value());
  EXPECT_EQ(reason, "start is closer to an obstacle than the robot's radius");
  const World goal_near_wall = empty_world(10, {5, 5}, {5, 9.9});
  EXPECT_FALSE(search(goal_near_wall, 0.25, 0.01, reason).has_value());
  EXPECT_EQ(reason, "goal is closer to an obstacle than the robot's radius");
}

TEST(ExactShortest, FindsPassagesThatAreJustWideEnough) {
  std::string reason;
  EXPECT_TRUE(search(walled_world(10, 0.8), 0.25, 0.01, reason).has_value()) << reason;
  EXPECT_FALSE(search(walled_world(10, 0.4), 0.25, 0.01, reason).has_value());
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

TEST(ExactShortest, BoundsHoldAgainstALatticeSearchInRandomWorlds) {
  RandomEngine engine(3);
  int solved = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const World world = random_world(engine, 5, 10);
    std::string reason;
    const auto best = search(world, 0.2, 0.01, reason);
    const double lattice = lattice_length(world, 0.2, 10);
    if (!best) {
      EXPECT_FALSE(std::isfinite(lattice)) << reason;
      continue;
    }
    ++solved;
    EXPECT_TRUE(is_free(world, best->path, 0.2));
    EXPECT_NEAR(length(best->path), best->length, 1e-12);
    EXPECT_LE(best->certificate.lower_bound, best->length);
    EXPECT_LE(best->certificate.lower_bound, lattice + 1e-9);
    EXPECT_LE(best->length, lattice * 1.0005) << "the lattice found a shorter path";
  }
  EXPECT_GT(solved, 20);
}

#if defined(SLALOM_SANITIZE)
constexpr int kWorlds = 100;
#else
constexpr int kWorlds = 1000;
#endif

TEST(ExactShortest, LowerBoundIsNeverAboveALatticeSearchInManyWorlds) {
  // Not a multiple of half a cell: no passage has exactly the width of the robot, which no bound
  // can distinguish from one that is too narrow.
  constexpr double kRadius = 0.16;
  RandomEngine engine(5);
  int solved = 0, reached = 0;
  for (int trial = 0; trial < kWorlds; ++trial) {
    const World world = random_world(engine, 3, uniform_int(engine, 1, 6));
    std::string reason;
    const auto best = search(world, kRadius, 0.01, reason);
    const double lattice = lattice_length(world, kRadius, 8);
    if (!best) {
      EXPECT_FALSE(std::isfinite(lattice)) << trial << ": " << reason;
      continue;
    }
    ++solved;
    EXPECT_TRUE(is_free(world, best->path, kRadius)) << trial;
    EXPECT_LE(best->certificate.lower_bound, best->length) << trial;
    EXPECT_LE(best->certificate.lower_bound, lattice + 1e-9) << trial;
    reached += best->certificate.gap() <= 0.01 ? 1 : 0;
  }
  EXPECT_GT(solved, kWorlds / 3);
  EXPECT_GT(reached, 0.95 * solved);
}

TEST(ExactShortest, GapIsReachedInRandomWorlds) {
  RandomEngine engine(4);
  int solved = 0, reached = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const World world = random_world(engine, 10, 25);
    std::string reason;
    const auto best = search(world, 0.25, 0.01, reason);
    if (!best) continue;
    ++solved;
    reached += best->certificate.gap() <= 0.01 ? 1 : 0;
  }
  EXPECT_GT(solved, 30);
  EXPECT_GE(reached, solved * 9 / 10);
}

}  // namespace
}  // namespace slalom
