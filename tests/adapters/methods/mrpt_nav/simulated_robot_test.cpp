// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_robot.h"

#include <gtest/gtest.h>
#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/kinematics/CVehicleVelCmd_Holo.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <cmath>

namespace slalom {
namespace {

RobotModel driven_robot() {
  RobotModel robot;
  robot.kinematics = Kinematics::Holonomic;
  robot.forward_only = false;
  return robot;
}

Observation at(double time, double phi) {
  Observation observation;
  observation.time = time;
  observation.odometry = {0, 0, phi};
  return observation;
}

Command diff_drive_command(const RobotModel& model, double v, double w) {
  SimulatedRobot robot(model, 0.1);
  robot.start_run(0.1);
  mrpt::kinematics::CVehicleVelCmd_DiffDriven command;
  command.lin_vel = v;
  command.ang_vel = w;
  robot.changeSpeeds(command);
  return robot.command();
}

TEST(SimulatedRobot, SlowsDownOnTheSameArcToBeWithinItsLimits) {
  const RobotModel robot;  // 1 m/s, 1.5 rad/s
  EXPECT_EQ(diff_drive_command(robot, 0.5, 1).v, 0.5);
  EXPECT_EQ(diff_drive_command(robot, 0.5, 1).w, 1);
  EXPECT_DOUBLE_EQ(diff_drive_command(robot, 2, 1).v, 1);
  EXPECT_DOUBLE_EQ(diff_drive_command(robot, 2, 1).w, 0.5);
  EXPECT_DOUBLE_EQ(diff_drive_command(robot, 0.5, -3).v, 0.25);
  EXPECT_DOUBLE_EQ(diff_drive_command(robot, 0.5, -3).w, -1.5);
  EXPECT_EQ(diff_drive_command(robot, -0.5, 1).v, 0);  // forward only
  RobotModel reversing;
  reversing.forward_only = false;
  EXPECT_EQ(diff_drive_command(reversing, -0.5, 1).v, -0.5);
  EXPECT_TRUE(
      std::isnan(diff_drive_command(robot, NAN, 0).v));  // passed on, to be rejected as invalid
}

TEST(SimulatedRobot, KeepsTheWorldDirectionWhileTurningToFaceIt) {
  SimulatedRobot robot(driven_robot(), 0.1);
  robot.start_run(0.1);
  robot.observe(at(0, M_PI / 2));
  // To its right, which is +x in the world, immediately.
  robot.changeSpeeds(mrpt::kinematics::CVehicleVelCmd_Holo(0.6, -M_PI / 2, 0, -1));
  EXPECT_NEAR(robot.command().v, 0, 1e-12);
  EXPECT_NEAR(robot.command().vy, -0.6, 1e-12);
  EXPECT_NEAR(robot.command().w, -1, 1e-12);
  robot.observe(at(1, M_PI / 4));
  EXPECT_NEAR(robot.command().v, 0.6 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(robot.command().vy, -0.6 * std::sqrt(0.5), 1e-12);
  // 0.05 rad remain: not more than that in a control period of 0.1 s.
  robot.observe(at(2, 0.05));
  EXPECT_NEAR(robot.command().w, -0.5, 1e-12);
}

TEST(SimulatedRobot, BlendsVelocitiesWithinTheRampTime) {
  SimulatedRobot robot(driven_robot(), 0.1);
  robot.start_run(0.1);
  Observation observation = at(0, 0);
  observation.v = 0.2;
  robot.observe(observation);
  robot.changeSpeeds(mrpt::kinematics::CVehicleVelCmd_Holo(1, 0, 0.4, 0));
  // At the end of the coming period a quarter of the ramp has passed: 0.2 + 0.8 / 4.
  EXPECT_NEAR(robot.command().v, 0.4, 1e-6);
  robot.observe(at(0.2, 0));
  EXPECT_NEAR(robot.command().v, 0.8, 1e-5);
  robot.observe(at(1, 0));
  EXPECT_DOUBLE_EQ(robot.command().v, 1);
  robot.stop(false);
  EXPECT_EQ(robot.command().v, 0);
}

TEST(SimulatedRobot, ReportsVelocitiesInTheWorldFrame) {
  SimulatedRobot robot(driven_robot(), 0.1);
  robot.start_run(0.1);
  Observation observation = at(0, M_PI / 2);
  observation.v = 0.5;
  observation.vy = 0.25;
  observation.w = 0.1;
  robot.observe(observation);
  mrpt::math::TPose2D pose, odometry;
  mrpt::math::TTwist2D velocity;
  mrpt::system::TTimeStamp time;
  std::string frame = "map";
  ASSERT_TRUE(robot.getCurrentPoseAndSpeeds(pose, velocity, time, odometry, frame));
  EXPECT_NEAR(velocity.vx, -0.25, 1e-12);
  EXPECT_NEAR(velocity.vy, 0.5, 1e-12);
  EXPECT_EQ(velocity.omega, 0.1);
  EXPECT_EQ(frame, "map");
}

TEST(SimulatedRobot, ReplacesObstaclesWithEachObservation) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(M_PI);
  scan.resizeScan(3);
  for (std::size_t i = 0; i < 3; ++i) {
    scan.setScanRange(i, 2);
    scan.setScanRangeValidity(i, i != 0);
  }
  Observation observation = at(0, 0);
  observation.scan = &scan;
  SimulatedRobot robot({}, 0.3);
  robot.start_run(0.1);
  mrpt::maps::CSimplePointsMap obstacles;
  mrpt::system::TTimeStamp time;
  EXPECT_FALSE(robot.senseObstacles(obstacles, time));  // before the first observation
  robot.observe(observation);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(robot.senseObstacles(obstacles, time));
  ASSERT_EQ(obstacles.size(), 2U);
  float x = 0, y = 0, z = 0;
  obstacles.getPoint(0, x, y, z);
  EXPECT_FLOAT_EQ(x, 2);
  EXPECT_FLOAT_EQ(z, 0.3F);
}

TEST(SimulatedRobot, TimerIsMonotonicWithIdenticalStepsInEachRun) {
  SimulatedRobot robot({}, 0.1);
  std::vector<double> first, last;
  double before = 0;
  for (int run = 0; run < 50; ++run) {
    robot.start_run(0.1);
    std::vector<double> steps;
    for (int cycle = 0; cycle < 30; ++cycle) {
      robot.observe(at(cycle * 0.1, 0));
      steps.push_back(robot.getNavigationTime() - before);
      EXPECT_GT(steps.back(), 0.02);  // navigators ignore poses at shorter intervals
      before = robot.getNavigationTime();
    }
    steps.erase(steps.begin());  // relative to the previous run
    if (run == 0) first = steps;
    last = steps;
  }
  EXPECT_EQ(first, last);  // exactly
}

}  // namespace
}  // namespace slalom
