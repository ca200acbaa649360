// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/trajectory.h>

#include <optional>
#include <string>

namespace slalom {

/// State at which a run leaves the path of one that reaches the goal in the same scenario.
struct Departure {
  double t = 0, speed = 0;      ///< s, m/s
  double goal_bearing = 0;      ///< rad, from the heading, positive to the left
  double obstacle_bearing = 0;  ///< rad, the same, of the nearest obstacle or mover
  double clearance = 0;         ///< m, from the robot's enclosing disc to it; at least 0
  bool is_mover = false;        ///< the nearest is a mover
};

/// The first sample whose position is farther than the robot's enclosing radius from the path of
/// `reference`; none if the run stays on it. The border is an obstacle.
/// `movers`: SimulationResult::movers of `run`.
std::optional<Departure> find_departure(const World& world, const Movers& movers,
                                        const RobotModel& robot, const Trajectory& run,
                                        const Trajectory& reference);

/// "nd leaves the path of gap after 3.20 s at 0.45 m/s; goal 12 degrees to the left, nearest
/// obstacle 60 degrees to the right, 0.25 m away", or that it does not leave it.
std::string departure_text(const std::string& method, const std::string& reference,
                           const std::optional<Departure>& departure);

/// rad, from the heading: the direction of the nearest static obstacle, to 5 degrees, as that in
/// which the clearance decreases most over `step` (m). The one closer to the heading, if two are
/// equal.
double bearing_of_obstacle(const World& world, const mrpt::math::TPose2D& pose, double step);

/// rad, from the heading, positive to the left.
double bearing_of(const mrpt::math::TPoint2D& point, const mrpt::math::TPose2D& pose);

}  // namespace slalom
