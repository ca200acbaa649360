// SPDX-License-Identifier: BSD-3-Clause
#include "common/rolling_memory.h"
#include "observations.h"

#include <gtest/gtest.h>

namespace reactive {
namespace {

const std::vector<double> kNoObstacles(181, 8.0);

std::vector<double> post_ahead(double range) {
  std::vector<double> ranges = kNoObstacles;
  for (std::size_t i = 88; i <= 92; ++i) ranges[i] = range;
  return ranges;
}

bool contains(const RollingMemory& memory, const Point& p, double within) {
  for (const Point& q : memory.points())
    if (distance(p, q) < within) return true;
  return false;
}

TEST(RollingMemory, KeepsPointsOutsideTheFieldOfView) {
  RollingMemory memory(4, 0.05);
  memory.update({0, 0, 0}, post_ahead(1), {});
  memory.update({0, 0, M_PI}, kNoObstacles, {});
  EXPECT_TRUE(contains(memory, {1, 0}, 1e-9));
}

TEST(RollingMemory, StoresPointsInTheOdometryFrame) {
  RollingMemory memory(4, 0.05);
  // From (2, 1), heading +y, one meter ahead is (2, 2).
  memory.update({2, 1, M_PI / 2}, post_ahead(1), {});
  EXPECT_TRUE(contains(memory, {2, 2}, 1e-9));
}

TEST(RollingMemory, RemovesPointsThatALaterScanSeesThrough) {
  RollingMemory memory(4, 0.05);
  memory.update({0, 0, 0}, post_ahead(1), {});
  memory.update({0, 0, 0}, post_ahead(3), {});
  EXPECT_FALSE(contains(memory, {1, 0}, 0.1));
  EXPECT_TRUE(contains(memory, {3, 0}, 0.1));
}

/// A wall at x = 1 m, seen with noise from (0, 0).
std::vector<double> noisy_wall(int scan) {
  std::vector<double> ranges = kNoObstacles;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double angle = ray_angle(i, ranges.size(), M_PI);
    const double noise = 0.07 * std::sin(12.9 * scan + 78.2 * static_cast<double>(i));
    if (std::cos(angle) > 0.7) ranges[i] = 1 / std::cos(angle) + noise;
  }
  return ranges;
}

/// How far the points are in front of the ends of the rays that lead past them, m.
double in_front(const RollingMemory& memory, const std::vector<double>& ranges) {
  double farthest = -HUGE_VAL;
  for (const Point& p : memory.points()) {
    const double ray = (std::atan2(p.y, p.x) / M_PI + 0.5) * 180;
    const double range = ranges[static_cast<std::size_t>(std::lround(ray))];
    farthest = std::max(farthest, range - std::hypot(p.x, p.y));
  }
  return farthest;
}

TEST(RollingMemory, NoiseDoesNotAddUpWhereRaysClear) {
  RollingMemory kept(4, 0.05), cleared(4, 0.05);
  const double diagonal = 0.05 * std::sqrt(2);
  for (int scan = 0; scan < 50; ++scan) {
    const std::vector<double> ranges = noisy_wall(scan);
    kept.update({}, ranges, {});
    cleared.clear_along({}, ranges, {}, 3);
    cleared.update({}, ranges, {});
    EXPECT_LT(in_front(cleared, ranges), diagonal) << scan;
  }
  EXPECT_GT(in_front(kept, noisy_wall(49)), diagonal);
}

TEST(RollingMemory, RaysClearNoCellsBehindTheirEndsBesideThemOrOutOfRange) {
  const auto after = [](const std::vector<double>& ranges, double range) {
    RollingMemory memory(4, 0.05);
    memory.update({}, post_ahead(2), {});
    memory.clear_along({}, ranges, {}, range);
    return contains(memory, {2, 0}, 0.1);
  };
  EXPECT_TRUE(after(post_ahead(1), 4));
  EXPECT_FALSE(after(post_ahead(3), 4));
  EXPECT_TRUE(after(post_ahead(3), 1.9));
  EXPECT_TRUE(after(post_ahead(3), 0));
  std::vector<double> beside(181, 1);
  beside[60] = 4;
  EXPECT_TRUE(after(beside, 4));
  // One ray is enough, as in costmap_2d.
  beside[90] = 4;
  RollingMemory memory(4, 0.05);
  memory.update({}, post_ahead(2), {});
  const std::size_t before = memory.points().size();
  memory.clear_along({}, beside, {}, 4);
  EXPECT_LT(memory.points().size(), before);
}

TEST(RollingMemory, KeepsOccludedPoints) {
  RollingMemory memory(4, 0.05);
  memory.update({0, 0, 0}, post_ahead(3), {});
  memory.update({0, 0, 0}, post_ahead(1), {});
  EXPECT_TRUE(contains(memory, {3, 0}, 0.1));
}

TEST(RollingMemory, ASingleInvalidRayRemovesNoPoint) {
  RollingMemory memory(4, 0.05);
  memory.update({0, 0, 0}, post_ahead(1), {});
  std::vector<double> dropped = post_ahead(1);
  dropped[90] = 8.0;
  memory.update({0, 0, 0}, dropped, {});
  EXPECT_TRUE(contains(memory, {1, 0}, 1e-9));
}

TEST(RollingMemory, RemovesPointsOutsideItsWindow) {
  RollingMemory memory(4, 0.05);
  memory.update({0, 0, 0}, post_ahead(1), {});
  memory.update({-3.2, 0, M_PI}, kNoObstacles, {});
  EXPECT_TRUE(memory.points().empty());
  memory.update({0, 0, M_PI}, kNoObstacles, {});
  EXPECT_TRUE(memory.points().empty());
}

TEST(RollingMemory, KeepsOnePointPerCellOverManyScans) {
  RollingMemory memory(4, 0.05);
  const auto walls = scan_of({{2.02, -1, 2.02, 1}});
  memory.update({0, 0, 0}, walls, {});
  const std::size_t once = memory.points().size();
  for (int i = 0; i < 50; ++i) memory.update({0, 0, 0}, walls, {});
  EXPECT_EQ(memory.points().size(), once);
  // A wall of 2 m covers 40 cells of 5 cm, or 41 if its ends are not on cell borders.
  EXPECT_LE(once, 41U);
}

TEST(RollingMemory, TheWindowWrapsAroundWithoutMixingPoints) {
  RollingMemory memory(1, 0.1);
  for (int i = 0; i < 100; ++i) memory.update({0.3 * i, 0, 0}, post_ahead(0.5), {});
  for (const Point& p : memory.points()) EXPECT_LT(std::abs(p.x - 29.7), 1.0);
  EXPECT_TRUE(contains(memory, {30.2, 0}, 1e-6));
}

}  // namespace
}  // namespace reactive
