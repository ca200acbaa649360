// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/parameters.h"

namespace dwa_local_planner {

/// Names and, unless noted, default values are those of the packages of the ROS navigation stack:
/// wiki.ros.org/dwa_local_planner, costmap_2d, move_base, clear_costmap_recovery, rotate_recovery;
/// of the back-up: nav2_behaviors. Lengths in m, times in s, angles in rad.
struct Parameters {
  // Limits; 0 is that of the robot.
  double max_vel_x = 0, min_vel_x = 0, max_vel_theta = 0;
  double min_vel_trans = 0.1, min_vel_theta = 0.4;  ///< at least one of them in each trajectory
  double acc_lim_x = 0, acc_lim_theta = 0;
  // Trajectories
  double sim_time = 1.7, sim_granularity = 0.025, angular_sim_granularity = 0.1;
  int vx_samples = 3, vth_samples = 20;
  double stop_time_buffer = 0.2;
  // Their costs
  double path_distance_bias = 32, goal_distance_bias = 20, occdist_scale = 0.01;
  double forward_point_distance = 0.325;
  double scaling_speed = 0.25, max_scaling_factor = 0.2;
  double oscillation_reset_dist = 0.05, oscillation_reset_angle = 0.2;
  double xy_goal_tolerance = 0;  ///< 0: half that of the task
  // Costmaps
  reactive::PathMap map = reactive::PathMap::Sensed;
  double width = 6, resolution = 0.05;
  double obstacle_range = 2.5;
  double raytrace_range = 0;  ///< 0: obstacles stay until several rays see through them
  double footprint_padding = 0.01, inflation_radius = 0.55, cost_scaling_factor = 10;
  // move_base
  double planner_frequency = 10;  ///< 1/s; 0: only when no trajectory is possible
  double planner_patience = 2, controller_patience = 2;
  double oscillation_timeout = 0, oscillation_distance = 0.5;
  bool recovery_behavior_enabled = true, clearing_rotation_allowed = true, backup_allowed = false;
  double conservative_reset_dist = 3;
  double backup_dist = 0.3, backup_speed = 0.1;

  void visit(slalom::OptionVisitor& v);
};

}  // namespace dwa_local_planner
