// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/methods/goal_turn.h>

#include <algorithm>
#include <cmath>

namespace slalom {

mrpt::math::TPose2D goal_pose(const NavigationTask& task) {
  const double direction = math::atan2(task.goal.y - task.start.y, task.goal.x - task.start.x);
  return {task.goal.x, task.goal.y, task.goal_heading.value_or(direction)};
}

std::optional<Command> turn_at_goal(const NavigationTask& task, const Observation& observation,
                                    const RobotModel& robot) {
  const auto& goal = observation.goal_in_robot;
  if (!task.goal_heading || math::hypot(goal.x, goal.y) > task.goal_tolerance) return std::nullopt;
  const double error = std::remainder(*task.goal_heading - observation.odometry.phi, 2 * M_PI);
  // The angular velocity from which the robot can stop within the error, with a reserve.
  constexpr double kBrakingShare = 0.7;
  const double limit =
      std::min({robot.max_w, std::abs(error) / task.control_period,
                std::sqrt(2 * kBrakingShare * robot.max_accel_w * std::abs(error))});
  return Command{0, std::copysign(limit, error), 0};
}

}  // namespace slalom
