// SPDX-License-Identifier: BSD-3-Clause
#include "test_runs.h"

#include <slalom/robot/diff_drive.h>

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// Distance to the occupied cells and the border of the grid, by brute force.
double brute_clearance(const Occupancy& cells, const TPoint2D& p) {
  const Bounds b = cells.bounds();
  double nearest = std::min({p.x - b.x_min, p.y - b.y_min, b.x_max - p.x, b.y_max - p.y});
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx) {
      if (!cells.occupied(cx, cy)) continue;
      const TPoint2D low = cells.to_world(cx, cy), high = cells.to_world(cx + 1, cy + 1);
      nearest = std::min(nearest, std::hypot(std::max({0.0, low.x - p.x, p.x - high.x}),
                                             std::max({0.0, low.y - p.y, p.y - high.y})));
    }
  return nearest;
}

/// Time of the first contact between a and b within one step, tested every 0.02 mm; negative if
/// there is none.
double brute_contact(const Occupancy& cells, const TPose2D& a, const TPose2D& b, double radius,
                     double step) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (brute_clearance(cells, {a.x, a.y}) > radius + length) return -1;
  const int pieces = std::max(1, static_cast<int>(length / 2e-5));
  for (int k = 0; k <= pieces; ++k) {
    const double fraction = static_cast<double>(k) / pieces;
    const TPoint2D p(a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y));
    if (brute_clearance(cells, p) < radius - 1e-9) return fraction * step;
  }
  return -1;
}

/// Replays the recorded commands and finds the first contact by brute force.
double replayed_contact(const World& world, const SimulationResult& result, const RobotModel& robot,
                        const SimulationOptions& options) {
  const Occupancy& cells = world.occupancy();
  DiffDrive vehicle(robot);
  vehicle.start_at(world.scenario().start());
  double time = 0;
  for (std::size_t i = 0; i < result.cycle_seconds.size(); ++i) {
    const Sample& sample = result.trajectory.samples[i];
    vehicle.command(sample.command_v, sample.command_w);
    for (double left = options.control_period; left > 1e-9; left -= options.step) {
      const TPose2D before = vehicle.getCurrentGTPose();
      vehicle.advance(options.step);
      const double contact =
          brute_contact(cells, before, vehicle.getCurrentGTPose(), robot.radius, options.step);
      if (contact >= 0) return time + contact;
      time += options.step;
    }
  }
  return -1;
}

TEST(Contact, AgreesWithBruteForceBetweenTheSteps) {
  RandomEngine random(3);
  SimulationOptions options;
  options.max_time = 4;
  options.step = 0.05;
  int collisions = 0;
  for (int i = 0; i < 60; ++i) {
    const World world = random_cells(random, 0.02);
    RobotModel robot;
    robot.max_v = 2;
    robot.radius = uniform_real(random, 0.03, 0.3);
    RandomMethod method(robot);
    const SimulationResult result =
        run(world, method, options, robot, static_cast<std::uint64_t>(i));
    const double contact = replayed_contact(world, result, robot, options);
    EXPECT_EQ(result.outcome == Outcome::Collision, contact >= 0) << i;
    if (result.outcome != Outcome::Collision) continue;
    ++collisions;
    // One piece of brute force, 0.02 mm, at any speed above 1 cm/s.
    EXPECT_NEAR(result.trajectory.samples.back().t, contact, 2e-3) << i;
    EXPECT_NEAR(brute_clearance(world.occupancy(), result.trajectory.path().back()), robot.radius,
                1e-8);
  }
  EXPECT_GT(collisions, 15);
  EXPECT_LT(collisions, 60);
}

/// A wall one cell thick at x = 6 m.
World walled(const TPose2D& start) {
  constexpr double kResolution = 0.05;
  COccupancyGridMap2D map(0, 10, 0, 10, static_cast<float>(kResolution));
  map.fill(1.0F);
  for (unsigned y = 0; y < map.getSizeY(); ++y) map.setCell(120, static_cast<int>(y), 0.0F);
  return {Scenario::grid("wall", map, start, {9.5, 9.5}), kResolution};
}

TEST(Contact, NeverTunnelsThroughAWallOfOneCell) {
  RandomEngine random(9);
  for (int i = 0; i < 300; ++i) {
    RobotModel robot;
    robot.radius = uniform_real(random, 0.005, 0.3);
    robot.max_v = uniform_real(random, 0.5, 200);
    robot.max_accel_v = uniform_real(random, 1, 1e5);
    SimulationOptions options;
    options.control_period = 0.2;
    options.step = i % 2 == 0 ? 0.2 : 0.1;
    const World world = walled({uniform_real(random, 1, 5), 5, uniform_real(random, -0.3, 0.3)});
    FunctionMethod forward = constant_method(robot.max_v, 0);
    const SimulationResult result = run(world, forward, options, robot);
    ASSERT_EQ(result.outcome, Outcome::Collision);
    EXPECT_NEAR(result.trajectory.samples.back().pose.x, 6 - robot.radius, 1e-6);
  }
}

TEST(Contact, AllowsExactContact) {
  COccupancyGridMap2D map(0, 8, 0, 4, 0.25F);  // all coordinates are exact in binary
  map.fill(1.0F);
  for (int x = 0; x < 32; ++x) map.setCell(x, 3, 0.0F);
  const World touching{Scenario::grid("touching", map, {1, 1.25, 0}, {7, 1.25}), 0.25};
  const World nearer{Scenario::grid("nearer", map, {1, 1.25 - 1e-8, 0}, {7, 1.25}), 0.25};
  FunctionMethod forward = constant_method(1, 0);
  EXPECT_EQ(run(touching, forward).outcome, Outcome::Success);
  EXPECT_EQ(run(nearer, forward).outcome, Outcome::UnsolvableScenario);
}

TEST(Contact, IsAtTheTimeOfFirstContact) {
  const World world = walled({1, 5, 0});
  FunctionMethod forward = constant_method(1, 0);
  const SimulationResult result = run(world, forward);
  ASSERT_EQ(result.outcome, Outcome::Collision);
  // To x = 5.75 m: 0.5 m in the first second, 4.25 m at 1 m/s.
  EXPECT_NEAR(result.trajectory.duration(), 5.25, 1e-6);
  // MRPT stores a grid's resolution in single precision: 120 cells of 0.05F are 6.00000009 m.
  EXPECT_NEAR(result.trajectory.samples.back().pose.x, 5.75, 1e-6);
}

}  // namespace
}  // namespace slalom::testing
