// SPDX-License-Identifier: BSD-3-Clause
#include "test_runs.h"

#include <slalom/core/pose.h>
#include <slalom/robot/range_scan.h>
#include <slalom/simulation/range_finder.h>

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

LaserModel laser_at(const std::string& name, double x, double y, double yaw) {
  LaserModel laser;
  laser.name = name;
  laser.x = x;
  laser.y = y;
  laser.yaw = yaw;
  return laser;
}

SensorModel sensor_with(std::vector<LaserModel> lasers) {
  SensorModel sensor;
  sensor.lasers = std::move(lasers);
  return sensor;
}

std::vector<float> ranges_of(const mrpt::obs::CObservation2DRangeScan& scan) {
  std::vector<float> ranges;
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) ranges.push_back(scan.getScanRange(i));
  return ranges;
}

/// The scan that a method gets at a pose.
std::vector<float> scan_at(const World& world, const SensorModel& sensor, const TPose2D& pose,
                           std::uint64_t seed = 1) {
  RangeFinder finder(world, world.scenario().movers(), sensor, seed);
  Observation observation;
  finder.sense(pose, 0, mrpt::Clock::time_point(), observation);
  return ranges_of(*observation.scan);
}

World scattered(double fraction = 0.03) {
  RandomEngine random(4);
  return random_cells(random, fraction);
}

const TPose2D kMiddle(3, 3, 0.7);

TEST(Lasers, OneAtTheCenterWithTheRaysOfTheSensorIsTheSensor) {
  const World world = scattered();
  const auto merged = scan_at(world, sensor_with({laser_at("a", 0, 0, 0)}), kMiddle);
  const auto plain = scan_at(world, {}, kMiddle);
  ASSERT_EQ(merged.size(), plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_NEAR(merged[i], plain[i], 1e-5) << i;
}

TEST(Lasers, OneThatIsTurnedByWholeRaysGivesTheSameScanAllAround) {
  const World world = scattered();
  SensorModel plain;
  plain.aperture_deg = 360;
  plain.rays = 361;
  const auto expected = scan_at(world, plain, kMiddle);
  for (int degrees = -180; degrees <= 180; degrees += 15) {
    SensorModel turned = plain;
    turned.lasers = {laser_at("a", 0, 0, degrees * M_PI / 180)};
    turned.lasers[0].aperture_deg = 360;
    turned.lasers[0].rays = 361;
    const auto merged = scan_at(world, turned, kMiddle);
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(merged[i], expected[i], 1e-4) << degrees << " " << i;
  }
}

TEST(Lasers, EachMeasuresFromItsPoseOnTheRobot) {
  const World world = scattered();
  for (const bool upside_down : {false, true}) {
    SensorModel sensor = sensor_with({laser_at("a", 0.2, -0.1, 2.5), laser_at("b", -0.1, 0, -1)});
    sensor.lasers[0].upside_down = upside_down;
    sensor.lasers[0].rays = 37;
    sensor.lasers[0].aperture_deg = 270;
    sensor.lasers[0].max_range = 2;
    RangeFinder finder(world, world.scenario().movers(), sensor, 1);
    Observation observation;
    finder.sense(kMiddle, 0, mrpt::Clock::time_point(), observation);
    ASSERT_EQ(observation.lasers.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
      const LaserModel& laser = sensor.lasers[k];
      const auto& scan = *observation.lasers[k];
      EXPECT_EQ(scan.sensorLabel, laser.name);
      EXPECT_EQ(scan.sensorPose.x(), laser.x);
      ASSERT_EQ(scan.getScanSize(), static_cast<std::size_t>(laser.rays));
      for (int i = 0; i < laser.rays; ++i) {
        const double along = laser.aperture() * (i / (laser.rays - 1.0) - 0.5);
        const double angle = kMiddle.phi + laser.yaw + (laser.upside_down ? -along : along);
        const double range =
            world.ray_caster().cast(compose(kMiddle, {laser.x, laser.y}), angle, laser.max_range);
        EXPECT_NEAR(scan.getScanRange(static_cast<std::size_t>(i)), range, 1e-4);
      }
      // The points of the scan are where its rays end: on obstacles.
      for (const TPoint2D& point : scan_points(scan))
        EXPECT_LT(world.distance_field().clearance(compose(kMiddle, point)), 1e-3);
    }
  }
}

TEST(Lasers, ReturnsThatAreMergedLieOnObstacles) {
  // A return at a ray is the distance of a point within half the spacing of the laser's rays.
  RandomEngine random(8);
  const World world = scattered();
  for (int k = 0; k < 20; ++k) {
    const auto draw = [&](double most) { return uniform_real(random, -most, most); };
    SensorModel sensor = sensor_with({laser_at("a", draw(0.3), draw(0.3), draw(3)),
                                      laser_at("b", draw(0.3), draw(0.3), draw(3))});
    sensor.aperture_deg = 360;
    sensor.rays = 361;
    const auto ranges = scan_at(world, sensor, kMiddle);
    int returns = 0;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const auto range = static_cast<double>(ranges[i]);
      if (range >= sensor.max_range) continue;
      ++returns;
      const double angle = 2 * M_PI * (static_cast<double>(i) / 360 - 0.5);
      const TPoint2D end = compose(kMiddle, {range * std::cos(angle), range * std::sin(angle)});
      // One degree at up to range + 0.6 m, seen from lasers and robot.
      EXPECT_LT(world.distance_field().clearance(end), 0.0175 * (range + 0.6) + 1e-3) << i;
    }
    EXPECT_GT(returns, 100);
  }
}

TEST(Lasers, TwoSeeAllAroundWhatOneWouldSeeFromTheCenter) {
  // Nothing hides a wall of a square room from any of them.
  const World world(Scenario::continuous("room", {0, 0, 6, 6}, {}, {3, 3, 0.7}, {1, 1}), 0.05);
  SensorModel around;
  around.aperture_deg = 360;
  around.rays = 721;
  SensorModel both = around;
  both.lasers = {laser_at("front", 0.2, 0.15, 0.8), laser_at("rear", -0.2, -0.15, 0.8 - M_PI)};
  for (LaserModel& laser : both.lasers) {
    laser.aperture_deg = 270;
    laser.rays = 1081;
  }
  const auto center = scan_at(world, around, kMiddle), merged = scan_at(world, both, kMiddle);
  for (std::size_t i = 0; i < center.size(); ++i) {
    // Half a degree along a wall that is seen at 45 degrees or more.
    EXPECT_NEAR(merged[i], center[i], 0.0088 * center[i] + 0.01F) << i;
    EXPECT_LT(merged[i], around.max_range);
  }
}

TEST(Lasers, ARawOneGivesMethodsItsRangesAsTheyAre) {
  const World world = scattered();
  SensorModel sensor = sensor_with({laser_at("a", 0.2, 0, 0.5)});
  sensor.lasers[0].raw = true;
  RangeFinder finder(world, world.scenario().movers(), sensor, 1);
  Observation observation;
  finder.sense(kMiddle, 0, mrpt::Clock::time_point(), observation);
  EXPECT_EQ(observation.scan, observation.lasers[0]);
  EXPECT_EQ(
      ranges_of(*observation.scan),
      scan_at(world, {},
              {compose(kMiddle, {0.2, 0}).x, compose(kMiddle, {0.2, 0}).y, kMiddle.phi + 0.5}));
}

TEST(Lasers, ObstaclesNearerThanItsMinimumRangeAreNotSeen) {
  const World world = scattered();
  SensorModel sensor = sensor_with({laser_at("a", 0, 0, 0)});
  sensor.lasers[0].raw = true;
  const auto all = scan_at(world, sensor, kMiddle);
  sensor.lasers[0].range_min = 1.5;
  const auto far = scan_at(world, sensor, kMiddle);
  int near = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    near += all[i] < 1.5F ? 1 : 0;
    EXPECT_EQ(far[i], all[i] < 1.5F ? 8 : all[i]);
  }
  EXPECT_GT(near, 10);
}

TEST(Lasers, TheNoiseOfOneDoesNotDependOnTheOthers) {
  const World world = scattered();
  const auto ranges_of_a = [&](std::vector<LaserModel> lasers) {
    SensorModel sensor = sensor_with(std::move(lasers));
    sensor.noise_sigma = 0.05;
    sensor.dropout_ratio = 0.1;
    RangeFinder finder(world, world.scenario().movers(), sensor, 3);
    Observation observation;
    finder.sense(kMiddle, 0, mrpt::Clock::time_point(), observation);
    return std::pair(ranges_of(*observation.lasers.front()), ranges_of(*observation.lasers.back()));
  };
  const LaserModel a = laser_at("a", 0.1, 0, 0), same_place = laser_at("b", 0.1, 0, 0);
  const auto alone = ranges_of_a({a}), both = ranges_of_a({a, same_place});
  EXPECT_EQ(alone.first, both.first);
  EXPECT_NE(both.first, both.second);
}

TEST(Lasers, AMovingObstacleIsSeenByEachOfThem) {
  Mover mover;
  mover.id = "a";
  mover.radius = 0.3;
  mover.waypoints = {{0, {3, 1}}, {10, {3, 5}}};
  const World world(
      Scenario::continuous("room", {0, 0, 6, 6}, {}, {1, 3, 0}, {1, 1}).with_movers({mover}), 0.05);
  RangeFinder finder(world, world.scenario().movers(),
                     sensor_with({laser_at("a", 0.2, 0, 0), laser_at("b", -0.2, 0, 0)}), 1);
  Observation observation;
  finder.sense({1, 3, 0}, 5, mrpt::Clock::time_point(), observation);  // it is at (3, 3)
  EXPECT_NEAR(observation.lasers[0]->getScanRange(90), 1.5, 1e-6);
  EXPECT_NEAR(observation.lasers[1]->getScanRange(90), 1.9, 1e-6);
  EXPECT_NEAR(observation.scan->getScanRange(90), 1.7, 1e-6);
}

}  // namespace
}  // namespace slalom::testing
