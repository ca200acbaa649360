// SPDX-License-Identifier: BSD-3-Clause
#include "dwa_local_planner/parameters.h"

namespace dwa_local_planner {

namespace {

using slalom::OptionVisitor;
using slalom::Range;

void visit_trajectories(Parameters& p, OptionVisitor& v) {
  v.option("max_vel_x", p.max_vel_x, "m/s", "maximum linear velocity; 0: that of the robot",
           Range::at_least(0));
  v.option("min_vel_x", p.min_vel_x, "m/s", "minimum linear velocity, negative to reverse",
           Range::at_least(-10));
  v.option("max_vel_theta", p.max_vel_theta, "rad/s",
           "maximum angular velocity; 0: that of the robot", Range::at_least(0));
  v.option("min_vel_trans", p.min_vel_trans, "m/s", "trajectories are at least this fast, or turn",
           Range::at_least(0));
  v.option("min_vel_theta", p.min_vel_theta, "rad/s", "slower trajectories turn at least this fast",
           Range::at_least(0));
  v.option("acc_lim_x", p.acc_lim_x, "m/s^2", "linear acceleration; 0: that of the robot",
           Range::at_least(0));
  v.option("acc_lim_theta", p.acc_lim_theta, "rad/s^2",
           "angular acceleration; 0: that of the robot", Range::at_least(0));
  v.option("sim_time", p.sim_time, "s", "simulated time", Range::between(0.1, 30));
  v.option("sim_granularity", p.sim_granularity, "m", "length of a simulated step",
           Range::between(0.005, 1));
  v.option("angular_sim_granularity", p.angular_sim_granularity, "rad",
           "rotation in a simulated step", Range::between(0.005, 1));
  v.option("vx_samples", p.vx_samples, "-", "linear velocities", Range::between(2, 100));
  v.option("vth_samples", p.vth_samples, "-", "angular velocities", Range::between(2, 200));
  v.option("stop_time_buffer", p.stop_time_buffer, "s",
           "the robot can stop this long before it would collide", Range::at_least(0));
}

void visit_costs(Parameters& p, OptionVisitor& v) {
  v.option("path_distance_bias", p.path_distance_bias, "1/m",
           "weight of the distance from the path", Range::at_least(0));
  v.option("goal_distance_bias", p.goal_distance_bias, "1/m",
           "weight of the distance to the local goal", Range::at_least(0));
  v.option("occdist_scale", p.occdist_scale, "-", "weight of the highest cost under the footprint",
           Range::at_least(0));
  v.option("forward_point_distance", p.forward_point_distance, "m",
           "of the point ahead that is scored, too", Range::between(0, 10));
  v.option("scaling_speed", p.scaling_speed, "m/s", "a faster robot has a larger footprint",
           Range::at_least(0));
  v.option("max_scaling_factor", p.max_scaling_factor, "-",
           "by this fraction at the maximum velocity", Range::at_least(0));
  v.option("oscillation_reset_dist", p.oscillation_reset_dist, "m",
           "after a reversal no other within this distance", Range::at_least(0));
  v.option("oscillation_reset_angle", p.oscillation_reset_angle, "rad", "... or this rotation",
           Range::at_least(0));
  v.option("xy_goal_tolerance", p.xy_goal_tolerance, "m",
           "the robot stops this close to the goal; 0: half the tolerance of the task",
           Range::at_least(0));
  v.option("map", p.map, "known: the path is planned on the map of the environment");
  v.option("width", p.width, "m", "side length of the local costmap", Range::between(1, 50));
  v.option("resolution", p.resolution, "m", "cells of the costmaps", Range::between(0.01, 0.5));
  v.option("obstacle_range", p.obstacle_range, "m", "obstacles are marked up to this distance",
           Range::between(0.1, 100));
  v.option(
      "raytrace_range", p.raytrace_range, "m",
      "rays clear the cells that they lead through up to this distance; 0: obstacles stay until "
      "four rays see through them",
      Range::between(0, 100));
  v.option("footprint_padding", p.footprint_padding, "m", "added to the footprint",
           Range::between(0, 10));
  v.option("inflation_radius", p.inflation_radius, "m", "farther from obstacles there are no costs",
           Range::between(0, 10));
  v.option("cost_scaling_factor", p.cost_scaling_factor, "1/m",
           "decay of the costs with the distance", Range::at_least(0));
}

void visit_recovery(Parameters& p, OptionVisitor& v) {
  v.option("planner_frequency", p.planner_frequency, "1/s",
           "of new paths; 0: only when no trajectory is possible", Range::at_least(0));
  v.option("planner_patience", p.planner_patience, "s", "time without a path before a recovery",
           Range::at_least(0));
  v.option("controller_patience", p.controller_patience, "s",
           "time without a trajectory before a recovery", Range::at_least(0));
  v.option("oscillation_timeout", p.oscillation_timeout, "s",
           "time without progress before a recovery; 0: never", Range::at_least(0));
  v.option("oscillation_distance", p.oscillation_distance, "m", "distance that counts as progress",
           Range::at_least(0));
  v.option("recovery_behavior_enabled", p.recovery_behavior_enabled,
           "whether there are recovery behaviors");
  v.option("clearing_rotation_allowed", p.clearing_rotation_allowed,
           "whether one of them is a rotation in place");
  v.option("backup_allowed", p.backup_allowed, "whether one of them is to back up");
  v.option("conservative_reset_dist", p.conservative_reset_dist, "m",
           "side of the square kept by the conservative reset", Range::at_least(0));
  v.option("backup_dist", p.backup_dist, "m", "how far to back up", Range::at_least(0));
  v.option("backup_speed", p.backup_speed, "m/s", "how fast to back up", Range::at_least(0));
}

}  // namespace

void Parameters::visit(OptionVisitor& v) {
  visit_trajectories(*this, v);
  visit_costs(*this, v);
  visit_recovery(*this, v);
}

}  // namespace dwa_local_planner
