#include "dwa_local_planner/parameters.h"

namespace dwa_local_planner {

namespace {

constexpr const char* kMaps[] = {"sensed", "known", nullptr};
constexpr const char* kTruth[] = {"false", "true", nullptr};

using P = Parameters;

constexpr Settings kSettings = {
    {{"max_vel_x", "0", "m/s", "maximum linear velocity; 0: that of the robot"}, &P::max_vel_x},
    {{"min_vel_x", "0", "m/s", "minimum linear velocity, negative to reverse"}, &P::min_vel_x, -10},
    {{"max_vel_theta", "0", "rad/s", "maximum angular velocity; 0: that of the robot"},
     &P::max_vel_theta},
    {{"min_vel_trans", "0.1", "m/s", "trajectories are at least this fast, or turn"},
     &P::min_vel_trans},
    {{"min_vel_theta", "0.4", "rad/s", "slower trajectories turn at least this fast"},
     &P::min_vel_theta},
    {{"acc_lim_x", "0", "m/s^2", "linear acceleration; 0: that of the robot"}, &P::acc_lim_x},
    {{"acc_lim_theta", "0", "rad/s^2", "angular acceleration; 0: that of the robot"},
     &P::acc_lim_theta},
    {{"sim_time", "1.7", "s", "simulated time"}, &P::sim_time, 0.1, 30},
    {{"sim_granularity", "0.025", "m", "length of a simulated step"},
     &P::sim_granularity,
     0.005,
     1},
    {{"angular_sim_granularity", "0.1", "rad", "rotation in a simulated step"},
     &P::angular_sim_granularity,
     0.005,
     1},
    {{"vx_samples", "3", "-", "linear velocities"}, &P::vx_samples, 2, 100},
    {{"vth_samples", "20", "-", "angular velocities"}, &P::vth_samples, 2, 200},
    {{"stop_time_buffer", "0.2", "s", "the robot can stop this long before it would collide"},
     &P::stop_time_buffer},
    {{"path_distance_bias", "32", "1/m", "weight of the distance from the path"},
     &P::path_distance_bias},
    {{"goal_distance_bias", "20", "1/m", "weight of the distance to the local goal"},
     &P::goal_distance_bias},
    {{"occdist_scale", "0.01", "-", "weight of the highest cost under the footprint"},
     &P::occdist_scale},
    {{"forward_point_distance", "0.325", "m", "of the point ahead that is scored, too"},
     &P::forward_point_distance,
     0,
     10},
    {{"scaling_speed", "0.25", "m/s", "a faster robot has a larger footprint"}, &P::scaling_speed},
    {{"max_scaling_factor", "0.2", "-", "by this fraction at the maximum velocity"},
     &P::max_scaling_factor},
    {{"oscillation_reset_dist", "0.05", "m", "after a reversal no other within this distance"},
     &P::oscillation_reset_dist},
    {{"oscillation_reset_angle", "0.2", "rad", "... or this rotation"},
     &P::oscillation_reset_angle},
    {{"xy_goal_tolerance", "0.1", "m", "the robot stops this close to the goal"},
     &P::xy_goal_tolerance},
    {{"map", "sensed", "-", "known: the path is planned on the map of the environment"},
     &P::map,
     0,
     1,
     kMaps},
    {{"width", "6", "m", "side length of the local costmap"}, &P::width, 1, 50},
    {{"resolution", "0.05", "m", "cells of the costmaps"}, &P::resolution, 0.01, 0.5},
    {{"obstacle_range", "2.5", "m", "obstacles are marked up to this distance"},
     &P::obstacle_range,
     0.1,
     100},
    {{"footprint_padding", "0.01", "m", "added to the footprint"}, &P::footprint_padding, 0, 10},
    {{"inflation_radius", "0.55", "m", "farther from obstacles there are no costs"},
     &P::inflation_radius,
     0,
     10},
    {{"cost_scaling_factor", "10", "1/m", "decay of the costs with the distance"},
     &P::cost_scaling_factor},
    {{"planner_frequency", "10", "1/s", "of new paths; 0: only when no trajectory is possible"},
     &P::planner_frequency},
    {{"planner_patience", "2", "s", "time without a path before a recovery"}, &P::planner_patience},
    {{"controller_patience", "2", "s", "time without a trajectory before a recovery"},
     &P::controller_patience},
    {{"oscillation_timeout", "0", "s", "time without progress before a recovery; 0: never"},
     &P::oscillation_timeout},
    {{"oscillation_distance", "0.5", "m", "... of this distance"}, &P::oscillation_distance},
    {{"recovery_behavior_enabled", "true", "-", "whether there are recovery behaviors"},
     &P::recovery_behavior_enabled,
     0,
     1,
     kTruth},
    {{"clearing_rotation_allowed", "true", "-", "whether one of them is a rotation in place"},
     &P::clearing_rotation_allowed,
     0,
     1,
     kTruth},
    {{"backup_allowed", "false", "-", "whether one of them is to back up"},
     &P::backup_allowed,
     0,
     1,
     kTruth},
    {{"conservative_reset_dist", "3", "m", "side of the square that the first one does not clear"},
     &P::conservative_reset_dist},
    {{"backup_dist", "0.3", "m", "how far to back up"}, &P::backup_dist},
    {{"backup_speed", "0.1", "m/s", "how fast to back up"}, &P::backup_speed}};

}  // namespace

const Settings& settings() {
  return kSettings;
}

}  // namespace dwa_local_planner
