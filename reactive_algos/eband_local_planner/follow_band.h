// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/motion.h"
#include "eband_local_planner/elastic_band.h"

#include <vector>

namespace eband_local_planner {

/// Parameters of the trajectory controller of eband_local_planner, for robots with differential
/// drive.
struct ControllerParameters {
  double max_vel_lin = 0;                 ///< m/s, at most that of the robot
  double max_vel_th = 0;                  ///< rad/s, at most that of the robot
  double min_vel_lin = 0.1;               ///< m/s
  double min_vel_th = 0;                  ///< rad/s
  double min_in_place_vel_th = 0;         ///< rad/s
  double k_prop = 4;                      ///< 1/s, angular velocity per bearing of the next bubble
  double bubble_velocity_multiplier = 2;  ///< 1/m
  double rotation_threshold_multiplier = 1;
};

/// The command at `pose` of a robot whose bubble is the first one: towards the center of the next
/// bubble, as fast as its own bubble is large; in place if the bearing of that center is larger
/// than the angle which the next bubble subtends.
reactive::Twist follow(const std::vector<Bubble>& band, const reactive::Pose& pose,
                       const ControllerParameters& parameters);

}  // namespace eband_local_planner
