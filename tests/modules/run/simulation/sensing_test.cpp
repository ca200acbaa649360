// SPDX-License-Identifier: BSD-3-Clause
#include "test_runs.h"

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>

namespace slalom::testing {
namespace {

/// The center of a square of 30 m, a disc of 1 m to the left at 4 m.
World hall() {
  Primitives obstacles;
  obstacles.discs.push_back({{15, 20}, 1});
  return {Scenario::continuous("hall", {0, 0, 30, 30}, obstacles, {15, 15, 0}, {29, 29}), 0.05};
}

TEST(Sensing, CastsRaysCounterClockwiseFromTheRight) {
  FunctionMethod method([](const Observation& o) {
    EXPECT_EQ(o.scan->getScanSize(), 181U);
    EXPECT_TRUE(o.scan->rightToLeft);
    EXPECT_FLOAT_EQ(o.scan->aperture, static_cast<float>(M_PI));
    EXPECT_FLOAT_EQ(o.scan->maxRange, 8);
    EXPECT_NEAR(o.scan->getScanRange(180), 4, 0.05 + 1e-6);  // a cell is occupied if it is touched
    EXPECT_TRUE(o.scan->getScanRangeValidity(180));
    for (std::size_t i = 0; i < 160; ++i) {
      EXPECT_FLOAT_EQ(o.scan->getScanRange(i), 8);
      EXPECT_FALSE(o.scan->getScanRangeValidity(i));
    }
    return Command{0, 0};
  });
  SimulationOptions options;
  options.max_time = 0.5;
  EXPECT_EQ(run(hall(), method, options).outcome, Outcome::Timeout);
}

TEST(Sensing, AgreesWithTheRayCasterAtTheRobotsPose) {
  RandomEngine random(4);
  const World world = random_cells(random, 0.02);
  const SensorModel sensor{270, 97, 3};
  FunctionMethod method([&](const Observation& o) {
    for (int i = 0; i < sensor.rays; ++i) {
      const double angle =
          o.odometry.phi - 0.5 * sensor.aperture() + sensor.aperture() * i / (sensor.rays - 1);
      const double range =
          world.ray_caster().cast({o.odometry.x, o.odometry.y}, angle, sensor.max_range);
      EXPECT_NEAR(o.scan->getScanRange(static_cast<std::size_t>(i)), range, 1e-4);
    }
    return Command{0.5, 1};
  });
  SimulationOptions options;
  options.max_time = 3;
  simulate(world, {{}, sensor, {}, options, {}}, 1, method);
}

TEST(Sensing, PlacesTheGoalInTheRobotsFrame) {
  FunctionMethod method([](const Observation& o) {
    // Robot at (5, 5) heading along +y, goal at (4, 8): 3 m ahead, 1 m to the left.
    EXPECT_NEAR(o.goal_in_robot.x, 3, 1e-12);
    EXPECT_NEAR(o.goal_in_robot.y, 1, 1e-12);
    return Command{0, 0};
  });
  run(square_world({5, 5, M_PI / 2}, {4, 8}), method);
}

TEST(Sensing, NeverShowsThePointsOfAnEarlierScan) {
  int cycles = 0;
  FunctionMethod method([&](const Observation& o) {
    const auto* points = o.scan->buildAuxPointsMap<mrpt::maps::CPointsMap>();
    float ahead = 0;
    for (const float x : points->getPointsBufferRef_x()) ahead = std::max(ahead, x);
    EXPECT_NEAR(ahead, o.scan->getScanRange(90), 1e-3);
    ++cycles;
    return Command{1, 0};
  });
  Primitives wall;
  wall.polygons.push_back({{{8, 0}, {8.2, 0}, {8.2, 10}, {8, 10}}});
  run(square_world({2, 5, 0}, {7, 5}, wall), method);
  EXPECT_GT(cycles, 40);
}

}  // namespace
}  // namespace slalom::testing
