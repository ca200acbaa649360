// SPDX-License-Identifier: BSD-3-Clause
#include "sectors.h"

#include <slalom/core/random.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

/// The free distance found with small steps and bisection, where the disc would come closer than
/// its radius to a point, or penetrate one that it touches at the start.
double stepwise_free_distance(const std::vector<mrpt::math::TPoint2D>& points, double direction,
                              double radius, double limit) {
  const auto is_blocked = [&](double distance) {
    for (const auto& p : points) {
      const double gap =
          std::hypot(p.x - distance * std::cos(direction), p.y - distance * std::sin(direction));
      const bool nearing = p.x * std::cos(direction) + p.y * std::sin(direction) > distance;
      if (gap < radius && (nearing || gap < std::hypot(p.x, p.y))) return true;
    }
    return false;
  };
  constexpr double kStep = 1e-3;
  for (double distance = kStep; distance <= limit + kStep; distance += kStep) {
    if (!is_blocked(distance)) continue;
    double low = distance - kStep, high = distance;
    for (int i = 0; i < 30; ++i) {
      const double middle = 0.5 * (low + high);
      (is_blocked(middle) ? high : low) = middle;
    }
    return std::min(low, limit);
  }
  return limit;
}

std::vector<mrpt::math::TPoint2D> random_points(RandomEngine& random, int count, double nearest) {
  std::vector<mrpt::math::TPoint2D> points;
  while (static_cast<int>(points.size()) < count) {
    const mrpt::math::TPoint2D p{uniform_real(random, -3, 3), uniform_real(random, -3, 3)};
    if (std::hypot(p.x, p.y) > nearest) points.push_back(p);
  }
  return points;
}

TEST(FreeDistance, EqualsTheDistanceFoundStepwise) {
  RandomEngine random(7);
  for (int round = 0; round < 60; ++round) {
    const auto points = random_points(random, 1 + round % 12, 0.35);
    const double direction = uniform_real(random, -M_PI, M_PI);
    const double radius = uniform_real(random, 0.05, 0.35);
    EXPECT_NEAR(free_distance(points, direction, radius, 2.5),
                stepwise_free_distance(points, direction, radius, 2.5), 1e-3)
        << round;
  }
}

TEST(LimitUnseen, TakesTheDistanceAtThatEdgeOfTheScan) {
  // Twelve sectors of 30 degrees; those at -75 to 75 degrees are seen: 3 to 8.
  const std::vector<double> seen = {9, 9, 9, 1.5, 2, 3, 3, 3, 2.5, 9, 0.4, 9};
  std::vector<double> distances = seen;
  limit_unseen(distances, M_PI, UnseenSectors::Edge, 3);
  EXPECT_EQ(distances, (std::vector<double>{1.5, 1.5, 1.5, 1.5, 2, 3, 3, 3, 2.5, 2.5, 0.4, 2.5}));
  distances = seen;
  limit_unseen(distances, M_PI, UnseenSectors::Free, 3);
  EXPECT_EQ(distances, (std::vector<double>{3, 3, 3, 1.5, 2, 3, 3, 3, 2.5, 3, 0.4, 3}));
  distances = seen;
  limit_unseen(distances, M_PI, UnseenSectors::Blocked, 3);
  EXPECT_EQ(distances, (std::vector<double>{0.5, 0.5, 0.5, 1.5, 2, 3, 3, 3, 2.5, 0.5, 0.4, 0.5}));
  distances = seen;
  limit_unseen(distances, 2 * M_PI, UnseenSectors::Edge, 3);
  EXPECT_EQ(distances, seen);
}

TEST(FreeDistance, EndsOneRadiusBeforeAPointAheadAndIgnoresOneBehind) {
  EXPECT_DOUBLE_EQ(free_distance({{2, 0}}, 0, 0.5, 8), 1.5);
  EXPECT_DOUBLE_EQ(free_distance({{2, 0}}, M_PI, 0.5, 8), 8);
  // Lateral offset 0.3, radius 0.5: contact where the point is sqrt(0.25 - 0.09) = 0.4 ahead.
  EXPECT_NEAR(free_distance({{2, 0.3}}, 0, 0.5, 8), 1.6, 1e-12);
  EXPECT_DOUBLE_EQ(free_distance({{2, 0.5}}, 0, 0.5, 8), 8);
  EXPECT_DOUBLE_EQ(free_distance({}, 1, 0.5, 8), 8);
}

TEST(FreeDistance, AllowsLeavingATouchedPointButNotPenetratingIt) {
  EXPECT_DOUBLE_EQ(free_distance({{0.3, 0}}, 0, 0.5, 8), 0);
  EXPECT_DOUBLE_EQ(free_distance({{0.3, 0}}, 0.9 * M_PI, 0.5, 8), 8);
}

TEST(Sectors, HaveTheFreeDistancesOfTheirDirectionsToTheBit) {
  RandomEngine random(8);
  for (int round = 0; round < 400; ++round) {
    // From points that the disc touches to points beyond the limit; the last ones at right angles.
    auto points = random_points(random, round % 60, 0.02);
    for (const double d : {0.35, 0.5, 2.85})
      points.insert(points.end(), {{d, 0}, {-d, 0}, {0, -d}});
    const std::size_t count = 8 + static_cast<std::size_t>(round) % 150;
    const double radius = round % 3 == 0 ? 0.35 : uniform_real(random, 0.01, 1);
    const auto distances = Sectors(count).free_distances(points, radius, 2.5);
    ASSERT_EQ(distances.size(), count);
    for (std::size_t k = 0; k < count; ++k)
      ASSERT_EQ(distances[k], free_distance(points, sector_direction(k, count), radius, 2.5))
          << "round " << round << ", sector " << k;
  }
}

TEST(SectorDirection, DividesTheCircleEvenlyFromBehindCounterClockwise) {
  EXPECT_NEAR(sector_direction(0, 4), -0.75 * M_PI, 1e-12);
  EXPECT_NEAR(sector_direction(3, 4), 0.75 * M_PI, 1e-12);
  EXPECT_NEAR(sector_direction(60, 121), 0,
              1e-12);  // with an odd number one sector points straight ahead
  for (std::size_t k = 1; k < 121; ++k)
    EXPECT_NEAR(sector_direction(k, 121) - sector_direction(k - 1, 121), 2 * M_PI / 121, 1e-12);
}

TEST(ObstaclePoints, AreTheEndPointsOfValidRays) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(M_PI);
  scan.resizeScan(5);
  for (std::size_t i = 0; i < 5; ++i) {
    scan.setScanRange(i, static_cast<float>(i + 1));
    scan.setScanRangeValidity(i, i != 1);
  }
  const auto points = obstacle_points(scan);
  // Rays at -90, -45 (invalid), 0, 45 and 90 degrees.
  ASSERT_EQ(points.size(), 4U);
  EXPECT_NEAR(points[0].x, 0, 1e-6);
  EXPECT_NEAR(points[0].y, -1, 1e-6);
  EXPECT_NEAR(points[1].x, 3, 1e-6);
  EXPECT_NEAR(points[2].x, 4 * std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(points[2].y, 4 * std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(points[3].y, 5, 1e-6);
}

TEST(ObstaclePoints, OfASingleRayLieAhead) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = 2;
  scan.resizeScan(1);
  scan.setScanRange(0, 3);
  scan.setScanRangeValidity(0, true);
  const auto points = obstacle_points(scan);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_DOUBLE_EQ(points[0].x, 3);
  EXPECT_DOUBLE_EQ(points[0].y, 0);
}

}  // namespace
}  // namespace slalom
