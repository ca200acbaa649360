// SPDX-License-Identifier: BSD-3-Clause
#include "eband_local_planner/elastic_band.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace eband_local_planner {
namespace {

using namespace reactive;

constexpr double kRadius = 0.2;                // m, of the robot
const double kMaxBubble = std::log(252) / 10;  // m
constexpr double kClearance = kRadius + 0.02;  // m, of paths

/// A map around the origin with obstacle points.
ClearanceMap map_with(const std::vector<Point>& points) {
  ClearanceMap map(4, 0.05, 1);
  map.build({0, 0}, points);
  return map;
}

std::vector<Point> line_of_points(const Point& a, const Point& b) {
  std::vector<Point> result;
  for (int i = 0; i <= 400; ++i)
    result.push_back({a.x + i * (b.x - a.x) / 400, a.y + i * (b.y - a.y) / 400});
  return result;
}

/// Walls at y = -half_width and y = half_width.
ClearanceMap corridor(double half_width) {
  std::vector<Point> points = line_of_points({-4, half_width}, {4, half_width});
  for (const Point& p : line_of_points({-4, -half_width}, {4, -half_width})) points.push_back(p);
  return map_with(points);
}

ClearanceMap post_at(const Point& center) {
  std::vector<Point> points;
  for (int i = 0; i < 60; ++i)
    points.push_back({center.x + 0.1 * std::cos(0.1 * i), center.y + 0.1 * std::sin(0.1 * i)});
  return map_with(points);
}

double length_of(const ElasticBand& band) {
  double result = 0;
  for (std::size_t i = 1; i < band.bubbles().size(); ++i)
    result += distance(band.bubbles()[i - 1].center, band.bubbles()[i].center);
  return result;
}

void expect_overlapping(const ElasticBand& band) {
  const auto& bubbles = band.bubbles();
  for (std::size_t i = 1; i < bubbles.size(); ++i)
    EXPECT_LT(distance(bubbles[i - 1].center, bubbles[i].center),
              0.7 * (bubbles[i - 1].radius + bubbles[i].radius))
        << i;
}

double largest_force(const ElasticBand& band) {
  double result = 0;
  for (std::size_t i = 1; i + 1 < band.bubbles().size(); ++i)
    result = std::max(result, std::hypot(band.force(i).x, band.force(i).y));
  return result;
}

/// A path that goes up and down between (-3, 0) and (3, 0).
std::vector<Point> wavy_path(double amplitude) {
  std::vector<Point> path;
  for (int i = 0; i <= 120; ++i)
    path.push_back({-3 + 0.05 * i, amplitude * std::sin(M_PI * i / 20)});
  return path;
}

TEST(Bubble, IsTheClearanceOfTheRobotUpToItsMaximum) {
  const ClearanceMap map = corridor(0.6);
  ElasticBand band({}, map, kRadius);
  ASSERT_TRUE(band.set_path({{-1, 0.1}, {0, 0.1}, {1, 0.1}}, kRadius));
  EXPECT_NEAR(band.bubbles().front().radius, 0.5 - kRadius, 1e-4);
  const ClearanceMap empty = map_with({});
  ElasticBand free({}, empty, kRadius);
  ASSERT_TRUE(free.set_path({{-1, 0}, {1, 0}}, kRadius));
  EXPECT_NEAR(free.bubbles().front().radius, kMaxBubble, 1e-12);
}

TEST(Bubble, HasTheMaximumRadiusBeyondTheInflationRadius) {
  const ClearanceMap map = corridor(0.6);
  BandParameters parameters;
  parameters.inflation_radius = 0.45;
  ElasticBand band(parameters, map, kRadius);
  ASSERT_TRUE(band.set_path({{-1, 0.1}, {1, 0.1}}, kRadius));
  EXPECT_NEAR(band.bubbles().front().radius, kMaxBubble, 1e-12) << "0.5 m from the wall";
  ASSERT_TRUE(band.set_path({{-1, 0.2}, {1, 0.2}}, kRadius));
  EXPECT_NEAR(band.bubbles().front().radius, 0.4 - kRadius, 1e-4);
}

TEST(ElasticBand, OfAStraightPathInFreeSpaceHasAsFewBubblesAsOverlap) {
  const ClearanceMap map = map_with({});
  ElasticBand band({}, map, kRadius);
  ASSERT_TRUE(band.set_path(wavy_path(0), kRadius));
  // Neighbors are closer than 0.7 (r + r) = 0.774 m: 8 gaps for 6 m, of points 0.05 m apart.
  EXPECT_EQ(band.bubbles().size(), 9U);
  expect_overlapping(band);
  EXPECT_LT(largest_force(band), 1e-9);
}

TEST(ElasticBand, ContractsToAStraightLineAndNeverGetsLonger) {
  const ClearanceMap map = map_with({});
  BandParameters parameters;
  parameters.eband_external_force_gain = 0;
  parameters.eband_significant_force_lower_bound = 0;  // shorten every step that overshoots
  ElasticBand band(parameters, map, kRadius);
  const std::vector<Point> path = wavy_path(1.5);
  ASSERT_TRUE(band.set_path(path, kRadius));
  double length = length_of(band);
  EXPECT_LT(length, 14);
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(band.update(path.front()));
    EXPECT_LE(length_of(band), length + 1e-12) << i;
    length = length_of(band);
    expect_overlapping(band);
  }
  EXPECT_NEAR(length, 6, 0.01) << "of the straight line";
}

TEST(ElasticBand, RestsInTheMiddleBetweenTwoWalls) {
  const ClearanceMap map = corridor(0.5);
  ElasticBand band({}, map, kRadius);
  std::vector<Point> path = wavy_path(0.2);
  ASSERT_TRUE(band.set_path(path, kClearance));
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(band.update(path.front()));
  expect_overlapping(band);
  for (const Bubble& bubble : band.bubbles()) EXPECT_NEAR(bubble.center.y, 0, 0.03);
  EXPECT_LT(largest_force(band), BandParameters().eband_significant_force_lower_bound);
}

TEST(ElasticBand, RestsInTheMiddleBetweenTwoPosts) {
  // Surfaces at y = 0.4 and y = -0.8: the middle is at -0.2.
  std::vector<Point> points = line_of_points({-0.1, 0.4}, {0.1, 0.4});
  for (const Point& p : line_of_points({-0.1, -0.8}, {0.1, -0.8})) points.push_back(p);
  const ClearanceMap map = map_with(points);
  BandParameters parameters;
  parameters.eband_internal_force_gain = 0.1;  // the band is straight without obstacles
  ElasticBand band(parameters, map, kRadius);
  const std::vector<Point> path = {{-2, 0}, {0, 0}, {2, 0}};
  ASSERT_TRUE(band.set_path(path, kClearance));
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(band.update(path.front()));
  const auto middle = std::min_element(
      band.bubbles().begin(), band.bubbles().end(),
      [](const Bubble& a, const Bubble& b) { return std::abs(a.center.x) < std::abs(b.center.x); });
  EXPECT_NEAR(middle->center.y, -0.2, 0.05);
  EXPECT_LT(largest_force(band), BandParameters().eband_significant_force_lower_bound);
}

TEST(ElasticBand, DeformsAroundAnObstacleThatMovesIntoIt) {
  ClearanceMap map = post_at({0, 1});
  ElasticBand band({}, map, kRadius);
  const std::vector<Point> path = wavy_path(0);
  ASSERT_TRUE(band.set_path(path, kClearance));
  for (double y = 1; y > -0.3; y -= 0.05) {
    map = post_at({0, y});
    ASSERT_TRUE(band.update(path.front())) << y;
    expect_overlapping(band);
    for (const Bubble& bubble : band.bubbles())
      EXPECT_GT(distance(bubble.center, {0, y}), 0.1 + kRadius) << y;
  }
  // It passes below the post, from where the post came from above.
  EXPECT_GT(length_of(band), 6);
  const bool below = std::any_of(band.bubbles().begin(), band.bubbles().end(),
                                 [](const Bubble& bubble) { return bubble.center.y < -0.5; });
  EXPECT_TRUE(below);
  // The band is straight again when the post is gone.
  map = map_with({});
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(band.update(path.front()));
  EXPECT_NEAR(length_of(band), 6, 0.02);
}

TEST(ElasticBand, SnapsAtAWall) {
  ClearanceMap map = map_with({});
  ElasticBand band({}, map, kRadius);
  const std::vector<Point> path = wavy_path(0);
  ASSERT_TRUE(band.set_path(path, kClearance));
  map = map_with(line_of_points({0, -4}, {0, 4}));
  EXPECT_FALSE(band.update(path.front()));
  EXPECT_TRUE(band.bubbles().empty());
  EXPECT_FALSE(band.update(path.front()));
  EXPECT_FALSE(band.set_path(path, kClearance));
  EXPECT_FALSE(band.set_path({}, kClearance));
}

TEST(ElasticBand, OfARobotThatIsWiderThanTheInflationRadiusIsFreeOfCollisions) {
  constexpr double kWide = 0.45;  // m
  const ClearanceMap map = corridor(0.6);
  BandParameters parameters;
  parameters.inflation_radius = 0.3;
  ElasticBand band(parameters, map, kWide);
  EXPECT_FALSE(band.set_path({{-1, 0}, {0, 0.4}}, kWide));
  ASSERT_TRUE(band.set_path(wavy_path(0.05), kWide));
  for (const Bubble& bubble : band.bubbles())
    EXPECT_LT(std::abs(bubble.center.y), 0.6 - kWide + 1e-3);
  // A post in the middle leaves 0.5 m on both sides.
  ClearanceMap blocked = post_at({0, 0});
  ElasticBand snapped(parameters, blocked, kWide);
  EXPECT_FALSE(snapped.set_path({{-1, 0}, {1, 0}}, kWide));
}

TEST(ElasticBand, BeginsAtTheRobotAndForgetsWhatIsBehindIt) {
  const ClearanceMap map = map_with({});
  ElasticBand band({}, map, kRadius);
  ASSERT_TRUE(band.set_path(wavy_path(0), kClearance));
  for (double x = -3; x < 2.9; x += 0.1) {
    ASSERT_TRUE(band.update({x, 0.02}));
    EXPECT_EQ(band.bubbles().front().center.x, x);
    EXPECT_EQ(band.bubbles().front().center.y, 0.02);
    EXPECT_GT(band.bubbles()[1].center.x, x);
    EXPECT_EQ(band.bubbles().back().center.x, 3);
  }
  EXPECT_EQ(band.bubbles().size(), 2U);
}

TEST(ElasticBand, LeavesAnObstacleThatIsCloserThanTheClearanceOfThePath) {
  const ClearanceMap map = corridor(0.5);
  ElasticBand band({}, map, kRadius);
  ASSERT_TRUE(band.set_path({{-1, 0.27}, {0, 0.1}, {1, 0}}, kClearance + 0.05));
  EXPECT_GT(band.bubbles().front().radius, 0) << "0.23 m from a wall, and 0.27 m wanted";
}

}  // namespace
}  // namespace eband_local_planner
