// SPDX-License-Identifier: BSD-3-Clause
#include "one_target.h"
#include "random_worlds.h"

#include <slalom/scenario/distance_field.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

double away(double low, double high, double x) {
  return std::max({0.0, low - x, x - high});
}

/// Distance from a point (in cells) to the nearest occupied square or to the border.
double nearest_square(const Occupancy& cells, const TPoint2D& p) {
  double nearest = std::max(
      0.0, std::min(std::min(p.x, p.y), std::min(cells.size_x() - p.x, cells.size_y() - p.y)));
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx)
      if (cells.occupied(cx, cy))
        nearest = std::min(nearest, std::hypot(away(cx, cx + 1, p.x), away(cy, cy + 1, p.y)));
  return nearest;
}

TEST(DistanceField, IsExactAtTheCentersOfRandomGrids) {
  RandomEngine random(10);
  for (int n = 0; n < 200; ++n) {
    const Occupancy cells = testing::random_occupancy(random, 30);
    const DistanceField field(cells);
    for (int cy = 0; cy < cells.size_y(); ++cy)
      for (int cx = 0; cx < cells.size_x(); ++cx) {
        const double expected =
            cells.resolution() * nearest_square(cells, TPoint2D(cx + 0.5, cy + 0.5));
        ASSERT_FLOAT_EQ(static_cast<float>(field.at_center(cx, cy)), static_cast<float>(expected));
        ASSERT_EQ(field.centers()[cells.index(cx, cy)], field.at_center(cx, cy));
      }
  }
}

/// Square of twice the distance (cells) from the center of a cell to the nearest occupied square or
/// the border.
long long squared_doubled_distance(const Occupancy& cells, bool empty, int cx, int cy) {
  const auto gap = [](long long a, long long b) { return a == b ? 0 : 2 * std::abs(a - b) - 1; };
  const long long wall = std::min(std::min(gap(cx, -1), gap(cx, cells.size_x())),
                                  std::min(gap(cy, -1), gap(cy, cells.size_y())));
  long long nearest = wall * wall;
  if (empty) return nearest;
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x)
      if (cells.occupied(x, y))
        nearest = std::min(nearest, gap(cx, x) * gap(cx, x) + gap(cy, y) * gap(cy, y));
  return nearest;
}

/// Small grids, and sizes at which the largest squares just fit into 16 bits, and do not.
std::vector<Occupancy> grids_up_to_large_distances() {
  RandomEngine random(14);
  std::vector<Occupancy> grids;
  for (int n = 0; n < 60; ++n) grids.push_back(testing::random_occupancy(random, 70));
  for (const int size : {255, 256, 257, 280})
    grids.emplace_back(size, size + 20, 0.05, TPoint2D(0, 0));
  return grids;
}

TEST(DistanceField, IsExactToTheBitWithEveryInstructionSet) {
  for (const Occupancy& cells : grids_up_to_large_distances()) {
    const bool empty = cells.count_occupied() == 0;
    std::vector<float> expected;
    for (int cy = 0; cy < cells.size_y(); ++cy)
      for (int cx = 0; cx < cells.size_x(); ++cx) {
        const auto square = static_cast<double>(squared_doubled_distance(cells, empty, cx, cy));
        expected.push_back(static_cast<float>(0.5 * cells.resolution() * std::sqrt(square)));
      }
    for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
      const testing::OneTarget target(left & -left);
      const DistanceField field(cells);
      ASSERT_TRUE(std::equal(expected.begin(), expected.end(), field.centers().begin()))
          << hwy::TargetName(left & -left) << ' ' << cells.size_x() << " x " << cells.size_y();
    }
  }
}

TEST(DistanceField, IsExactAtAnyPoint) {
  RandomEngine random(11);
  for (int n = 0; n < 200; ++n) {
    const Occupancy cells = testing::random_occupancy(random, 30);
    const DistanceField field(cells);
    for (int i = 0; i < 200; ++i) {
      TPoint2D q = testing::random_point(random, cells.bounds(), 2 * cells.resolution());
      if (i % 4 == 0)  // on borders and corners of cells too
        q = cells.to_world(uniform_int(random, 0, cells.size_x()),
                           0.5 * uniform_int(random, 0, 2 * cells.size_y()));
      const double expected = cells.resolution() * nearest_square(cells, cells.to_cells(q));
      ASSERT_NEAR(field.clearance(q), expected, 1e-12);
      ASSERT_LE(field.clearance_lower_bound(q), expected + 1e-12);
      ASSERT_GE(field.clearance_lower_bound(q), expected - 1.5 * cells.resolution());
    }
  }
}

TEST(DistanceField, IsZeroOnObstaclesOutsideAndForNonFinitePoints) {
  Occupancy cells(4, 4, 0.5, {0, 0});
  cells.set_occupied(2, 2, true);
  const DistanceField field(cells);
  EXPECT_EQ(field.clearance({1.2, 1.2}), 0);
  EXPECT_EQ(field.clearance({1.0, 1.0}), 0) << "the corner of the closed square";
  EXPECT_EQ(field.clearance({0, 1}), 0) << "on the wall";
  EXPECT_EQ(field.clearance({-3, 1}), 0);
  EXPECT_EQ(field.clearance({std::nan(""), 1}), 0);
  EXPECT_EQ(field.clearance({HUGE_VAL, 1}), 0);
  EXPECT_EQ(field.segment_clearance({std::nan(""), 1}, {0.5, 0.5}, 1), 0);
  EXPECT_DOUBLE_EQ(field.clearance({0.75, 0.5}), 0.5);
}

/// Distance between the segment a-b and a square, by ternary search for the nearest point of the
/// segment (the distance to a convex set is convex along it).
double segment_to_square(const TPoint2D& a, const TPoint2D& b, int cx, int cy) {
  const auto at = [&](double t) {
    return std::hypot(away(cx, cx + 1, a.x + t * (b.x - a.x)),
                      away(cy, cy + 1, a.y + t * (b.y - a.y)));
  };
  double low = 0, high = 1;
  for (int i = 0; i < 90; ++i) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    (at(left) <= at(right) ? high : low) = at(left) <= at(right) ? right : left;
  }
  return std::min({at(0.5 * (low + high)), at(0), at(1)});
}

double nearest_to_segment(const Occupancy& cells, const TPoint2D& a, const TPoint2D& b) {
  const auto wall = [&](const TPoint2D& p) {
    return std::max(
        0.0, std::min(std::min(p.x, p.y), std::min(cells.size_x() - p.x, cells.size_y() - p.y)));
  };
  double nearest = std::min(wall(a), wall(b));
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx)
      if (cells.occupied(cx, cy)) nearest = std::min(nearest, segment_to_square(a, b, cx, cy));
  return nearest;
}

TEST(DistanceField, FindsTheClearanceOfSegments) {
  RandomEngine random(12);
  for (int n = 0; n < 150; ++n) {
    const Occupancy cells = testing::random_occupancy(random, 14);
    const DistanceField field(cells);
    for (int i = 0; i < 40; ++i) {
      TPoint2D a = testing::random_point(random, cells.bounds(), 0.3 * cells.resolution());
      TPoint2D b = testing::random_point(random, cells.bounds());
      if (i % 4 == 0) a = cells.to_world(uniform_int(random, 0, cells.size_x()), 0.5);
      if (i % 8 == 0) b = cells.to_world(uniform_int(random, 0, cells.size_x()), 0.5);
      if (i % 16 == 1) b = a;
      const double expected =
          cells.resolution() * nearest_to_segment(cells, cells.to_cells(a), cells.to_cells(b));
      const double limit = uniform_real(random, 0.1, 4) * cells.resolution();
      ASSERT_NEAR(field.segment_clearance(a, b, limit), std::min(limit, expected), 1e-9);
      ASSERT_NEAR(field.segment_clearance(b, a, 1e9), expected, 1e-9);
      ASSERT_EQ(field.segment_clearance(a, b, 0), 0);
    }
  }
}

TEST(DistanceField, FindsTheClearanceInRowsLongerThanItsCountsReach) {
  constexpr int kLength = 200'000, kObstacle = 140'001;
  Occupancy cells(kLength, 5, 1, {0, 0});
  cells.set_occupied(kObstacle, 2, true);
  const DistanceField field(cells);
  EXPECT_EQ(field.clearance({70'000, 2.5}), 2.5) << "the border";
  EXPECT_EQ(field.clearance({kObstacle - 0.5, 2.5}), 0.5);
  EXPECT_EQ(field.segment_clearance({3, 2.5}, {199'990, 2.5}, 9), 0);
  EXPECT_EQ(field.segment_clearance({3, 3.5}, {199'990, 3.5}, 9), 0.5);
  for (const int begin : {65'534, 65'535, 65'536, 131'068, 131'069, 131'070})  // before it
    for (const double y : {2.5, 3.5, 4.5}) {
      const TPoint2D a(kObstacle - begin, y);
      const double wall = 5 - y, above = std::max(0.0, y - 3);
      EXPECT_DOUBLE_EQ(field.segment_clearance(a, {kObstacle - 0.25, y}, 9),
                       std::min(wall, std::hypot(above, 0.25)));
      EXPECT_EQ(field.segment_clearance(a, {kObstacle + 0.25, y}, 9), std::min(wall, above));
    }
}

TEST(DistanceField, FindsTheClearanceOfOutlines) {
  RandomEngine random(13);
  for (int n = 0; n < 300; ++n) {
    const Occupancy cells = testing::random_occupancy(random, 14);
    const DistanceField field(cells);
    std::vector<TPoint2D> corners;
    for (int i = 0; i < 4; ++i) corners.push_back(testing::random_point(random, cells.bounds()));
    double expected = 1e9;
    for (int i = 0; i < 4; ++i)
      expected = std::min(
          expected, cells.resolution() * nearest_to_segment(cells, cells.to_cells(corners[i]),
                                                            cells.to_cells(corners[(i + 1) % 4])));
    ASSERT_NEAR(field.outline_clearance(corners), expected, 1e-9);
  }
}

}  // namespace
}  // namespace slalom
