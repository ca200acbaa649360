// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/methods/method.h>

#include <optional>

namespace slalom {

/// The goal with its heading, or else the direction from the start to it; odometry frame.
mrpt::math::TPose2D goal_pose(const NavigationTask& task);

/// The command by which a robot that is within the tolerance of its goal stops there and turns to
/// the goal's heading; nullopt elsewhere, and if the goal has none. For methods without a concept
/// of it.
std::optional<Command> turn_at_goal(const NavigationTask& task, const Observation& observation,
                                    const RobotModel& robot);

}  // namespace slalom
