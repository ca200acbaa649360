// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/robot/vehicle.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

/// Practically unlimited accelerations.
RobotModel agile() {
  RobotModel robot;
  robot.max_accel_v = 1e6;
  robot.max_accel_w = 1e6;
  return robot;
}

TEST(Vehicle, IsChosenByTheRobotsKinematics) {
  RobotModel robot = agile();
  auto vehicle = make_vehicle(robot);
  vehicle->command(0.5, 0, 0.5);
  vehicle->advance(0.01);
  EXPECT_EQ(vehicle->vy(), 0) << "a differential drive has no lateral velocity";
  robot.kinematics = Kinematics::Holonomic;
  vehicle = make_vehicle(robot);
  vehicle->command(0.5, 0, 0.5);
  vehicle->advance(0.01);
  EXPECT_EQ(vehicle->vy(), 0.5);
}

TEST(Vehicle, StepLengthIsThatOfTheArcNotOfItsChord) {
  const auto vehicle = make_vehicle(agile());
  vehicle->command(1, 1.5);
  vehicle->advance(0.1);
  EXPECT_NEAR(vehicle->step_length(), 0.05, 1e-12) << "0.5 m/s on average";
  const auto before = vehicle->getCurrentGTPose();
  vehicle->advance(0.1);
  const auto after = vehicle->getCurrentGTPose();
  EXPECT_NEAR(vehicle->step_length(), 0.1, 1e-12);
  EXPECT_NEAR(std::hypot(after.x - before.x, after.y - before.y),
              2 / 1.5 * std::sin(0.5 * 1.5 * 0.1), 1e-12);
  vehicle->start_at({});
  EXPECT_EQ(vehicle->step_length(), 0);
}

TEST(Vehicle, AppliesACommandAfterItsDelay) {
  RobotModel robot = agile();
  robot.delay = 0.25;
  const auto vehicle = make_vehicle(robot);
  vehicle->command(1, 0);
  for (int step = 0; step < 25; ++step) {
    EXPECT_EQ(vehicle->v(), 0) << step;
    vehicle->advance(0.01);
  }
  vehicle->advance(0.01);
  EXPECT_EQ(vehicle->v(), 1);
}

TEST(Vehicle, AppliesDelayedCommandsInOrder) {
  RobotModel robot = agile();
  robot.delay = 0.05;
  const auto vehicle = make_vehicle(robot);
  std::vector<double> speeds;
  for (int step = 0; step < 12; ++step) {
    if (step < 4) vehicle->command(0.1 * (step + 1), 0);
    vehicle->advance(0.01);
    speeds.push_back(vehicle->v());
  }
  const std::vector<double> expected = {0, 0, 0, 0, 0, 0.1, 0.2, 0.1 * 3, 0.4, 0.4, 0.4, 0.4};
  EXPECT_EQ(speeds, expected);
}

TEST(Vehicle, ApproachesACommandWithItsTimeConstant) {
  RobotModel robot = agile();
  robot.delay_tau = 0.2;
  const auto vehicle = make_vehicle(robot);
  vehicle->command(1, 0);
  for (int step = 0; step < 20; ++step) vehicle->advance(0.01);
  // After one time constant 1 - 1/e of the change, independent of the step.
  EXPECT_NEAR(vehicle->v(), 1 - std::exp(-1), 1e-9);
}

TEST(Vehicle, StartAtClearsPendingCommands) {
  RobotModel robot = agile();
  robot.delay = 0.1;
  const auto vehicle = make_vehicle(robot);
  vehicle->command(1, 1);
  vehicle->advance(0.05);
  vehicle->start_at({3, 4, 0});
  for (int step = 0; step < 50; ++step) vehicle->advance(0.01);
  EXPECT_EQ(vehicle->getCurrentGTPose(), mrpt::math::TPose2D(3, 4, 0));
}

}  // namespace
}  // namespace slalom
