// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/robot/diff_drive.h>

#include <gtest/gtest.h>
#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/kinematics/CVehicleVelCmd_Holo.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPose2D;

constexpr double kStep = 0.01;  // s

void simulate(DiffDrive& vehicle, double seconds) {
  for (int i = 0; i < std::lround(seconds / kStep); ++i) vehicle.advance(kStep);
}

TEST(DiffDrive, IsAtRestAtItsStart) {
  DiffDrive vehicle{RobotModel()};
  EXPECT_EQ(vehicle.getTime(), 0);
  vehicle.start_at({1, 2, 0.5});
  vehicle.advance(kStep);
  EXPECT_EQ(vehicle.getCurrentGTPose(), TPose2D(1, 2, 0.5));
  EXPECT_EQ(vehicle.getCurrentOdometricPose(), TPose2D(1, 2, 0.5));
  EXPECT_EQ(vehicle.getTime(), kStep);
}

TEST(DiffDrive, ReachesItsVelocityWithMaximumAcceleration) {
  DiffDrive vehicle{RobotModel()};
  vehicle.command(0.8, 0);
  // At 1 m/s^2 after 0.5 s: v = 0.5 m/s, x = 0.5 * 0.5^2 = 0.125 m; exact for linear speed.
  simulate(vehicle, 0.5);
  EXPECT_NEAR(vehicle.v(), 0.5, 1e-12);
  EXPECT_NEAR(vehicle.getCurrentGTPose().x, 0.125, 1e-12);
  // Then 0.3 s to 0.8 m/s and 0.2 s there: x = 0.5 * 0.8^2 + 0.2 * 0.8 = 0.48 m.
  simulate(vehicle, 0.5);
  EXPECT_NEAR(vehicle.v(), 0.8, 1e-12);
  EXPECT_NEAR(vehicle.getCurrentGTPose().x, 0.48, 1e-12);
}

TEST(DiffDrive, StaysOnTheCircleOfItsVelocities) {
  DiffDrive vehicle{RobotModel()};
  vehicle.command(0.6, 1.2);
  simulate(vehicle, 1);  // both velocities are reached
  const TPose2D from = vehicle.getCurrentGTPose();
  const double radius = 0.6 / 1.2;
  const double x = from.x - radius * std::sin(from.phi), y = from.y + radius * std::cos(from.phi);
  for (int i = 0; i < 2000; ++i) {
    vehicle.advance(kStep);
    const TPose2D& at = vehicle.getCurrentGTPose();
    EXPECT_NEAR(std::hypot(at.x - x, at.y - y), radius, 1e-11);
    EXPECT_LE(std::abs(at.phi), M_PI);
  }
}

TEST(DiffDrive, RotatesInPlace) {
  DiffDrive vehicle{RobotModel()};
  vehicle.start_at({3, 4, 0});
  vehicle.command(0, 1.5);
  simulate(vehicle, 2);
  EXPECT_EQ(vehicle.getCurrentGTPose().x, 3);
  EXPECT_EQ(vehicle.getCurrentGTPose().y, 4);
  // 0.5 s to 1.5 rad/s at 3 rad/s^2 (0.375 rad), then 1.5 s at 1.5 rad/s.
  EXPECT_NEAR(vehicle.getCurrentGTPose().phi, 0.375 + 1.5 * 1.5, 1e-12);
}

TEST(DiffDrive, KeepsItsLimitsUnderAnyCommand) {
  RandomEngine random(5);
  for (const bool forward_only : {true, false}) {
    RobotModel robot;
    robot.forward_only = forward_only;
    DiffDrive vehicle(robot);
    for (int i = 0; i < 20000; ++i) {
      if (i % 7 == 0) vehicle.command(uniform_real(random, -3, 3), uniform_real(random, -5, 5));
      const double v = vehicle.v(), w = vehicle.w();
      const double dt = uniform_real(random, 0, 0.05);
      vehicle.advance(dt);
      EXPECT_LE(std::abs(vehicle.v() - v), robot.max_accel_v * dt + 1e-12);
      EXPECT_LE(std::abs(vehicle.w() - w), robot.max_accel_w * dt + 1e-12);
      EXPECT_LE(vehicle.v(), robot.max_v);
      EXPECT_GE(vehicle.v(), forward_only ? 0 : -robot.max_v);
      EXPECT_LE(std::abs(vehicle.w()), robot.max_w);
    }
  }
}

TEST(DiffDrive, ProvidesItsVelocityInWorldAndRobotFrameThroughMrptsInterface) {
  DiffDrive vehicle{RobotModel()};
  vehicle.start_at({0, 0, 2});
  vehicle.command(0.7, 0.4);
  vehicle.simulateOneTimeStep(3);
  const double phi = vehicle.getCurrentGTPose().phi;
  EXPECT_NEAR(vehicle.getCurrentGTVel().vx, 0.7 * std::cos(phi), 1e-12);
  EXPECT_NEAR(vehicle.getCurrentGTVel().vy, 0.7 * std::sin(phi), 1e-12);
  EXPECT_NEAR(vehicle.getCurrentGTVelLocal().vx, 0.7, 1e-12);
  EXPECT_NEAR(vehicle.getCurrentOdometricVelLocal().vy, 0, 1e-12);
  EXPECT_NEAR(vehicle.getCurrentGTVel().omega, 0.4, 1e-12);
}

TEST(DiffDrive, CanBeCommandedThroughMrptsInterface) {
  DiffDrive ours{RobotModel()}, vehicle{RobotModel()};
  mrpt::kinematics::CVehicleSimulVirtualBase& theirs = vehicle;
  mrpt::kinematics::CVehicleVelCmd_DiffDriven command;
  command.lin_vel = 0.9;
  command.ang_vel = 0.5;
  theirs.sendVelCmd(command);
  theirs.simulateOneTimeStep(2);
  ours.command(0.9, 0.5);
  simulate(ours, 2);
  // MRPT integrates with the velocity at the start of each of its steps of 0.5 ms, and may make one
  // more of them: the error is at most the distance of a few steps.
  EXPECT_NEAR(theirs.getCurrentGTPose().x, ours.getCurrentGTPose().x, 2e-3);
  EXPECT_NEAR(theirs.getCurrentGTPose().y, ours.getCurrentGTPose().y, 2e-3);
  EXPECT_NEAR(theirs.getCurrentGTPose().phi, ours.getCurrentGTPose().phi, 2e-3);
  EXPECT_NEAR(theirs.getCurrentOdometricPose().x, theirs.getCurrentGTPose().x, 1e-9);
  EXPECT_NEAR(theirs.getTime(), 2, 1e-3);
}

TEST(DiffDrive, RefusesCommandsOfOtherVehicles) {
  DiffDrive vehicle{RobotModel()};
  EXPECT_THROW(vehicle.sendVelCmd(mrpt::kinematics::CVehicleVelCmd_Holo()), std::invalid_argument);
  EXPECT_NO_THROW(vehicle.sendVelCmd(*vehicle.getVelCmdType()));
}

TEST(DiffDrive, KeepsItsMinimumTurningRadius) {
  RobotModel robot;
  robot.min_turning_radius = 0.5;
  DiffDrive vehicle(robot);
  vehicle.command(0, 1.5);
  simulate(vehicle, 1);
  EXPECT_EQ(vehicle.getCurrentGTPose(), mrpt::math::TPose2D());
  vehicle.command(0.4, 1.5);
  for (int step = 0; step < 200; ++step) {
    vehicle.advance(0.01);
    EXPECT_LE(std::abs(vehicle.w()), vehicle.v() / 0.5 + 1e-12);
  }
  EXPECT_DOUBLE_EQ(vehicle.w(), 0.8);
}

}  // namespace
}  // namespace slalom
