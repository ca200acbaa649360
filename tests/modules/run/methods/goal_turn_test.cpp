// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/methods/goal_turn.h>
#include <slalom/methods/registry.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

Observation at(double x, double y, double phi) {
  Observation observation;
  observation.odometry = {0, 0, phi};
  observation.goal_in_robot = {x, y};
  return observation;
}

NavigationTask task_with(std::optional<double> heading) {
  NavigationTask task;
  task.goal_tolerance = 0.2;
  task.control_period = 0.1;
  task.goal_heading = heading;
  return task;
}

TEST(GoalTurn, IsForGoalsWithAHeadingThatAreReached) {
  const RobotModel robot;
  EXPECT_FALSE(turn_at_goal(task_with(std::nullopt), at(0, 0.1, 0), robot));
  EXPECT_FALSE(turn_at_goal(task_with(1.0), at(0.2, 0.1, 0), robot));
  EXPECT_TRUE(turn_at_goal(task_with(1.0), at(0.1, 0.1, 0), robot));
}

TEST(GoalTurn, GoesTheShorterWayWithinTheLimits) {
  const RobotModel robot;
  for (double heading = -9; heading < 9; heading += 0.1) {
    const double error = std::remainder(heading - 0.4, 2 * M_PI);
    const Command command = *turn_at_goal(task_with(heading), at(0, 0, 0.4), robot);
    std::string reason;
    EXPECT_TRUE(is_valid_command(command, robot, reason)) << reason;
    EXPECT_EQ(command.v, 0);
    EXPECT_GE(command.w * error, 0);
    // It can stop within the error, and does not pass it within a control period.
    EXPECT_LE(command.w * command.w / (2 * robot.max_accel_w), std::abs(error) + 1e-12);
    EXPECT_LE(std::abs(command.w) * 0.1, std::abs(error) + 1e-12);
  }
}

}  // namespace
}  // namespace slalom
