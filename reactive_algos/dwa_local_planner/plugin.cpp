// SPDX-License-Identifier: BSD-3-Clause
#include "dwa_local_planner/dwa_local_planner.h"

const slalom_method_api* slalom_method_get_api(void) {
  return reactive::Plugin<dwa_local_planner::DwaLocalPlanner>::table("dwa_local_planner");
}

const slalom_map_api* slalom_method_get_map_api(void) {
  return reactive::Plugin<dwa_local_planner::DwaLocalPlanner>::map_table();
}

const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void) {
  return reactive::Plugin<dwa_local_planner::DwaLocalPlanner>::goal_heading_table();
}

// Ratios of the weights decide: path_distance_bias is left out.
const slalom_space_api* slalom_method_get_space_api(void) {
  return reactive::Plugin<dwa_local_planner::DwaLocalPlanner>::space_table(
      {{"sim_time", 0.8, 3, 1, 0},
       {"vx_samples", 2, 6, 0, 1},
       {"stop_time_buffer", 0, 0.6, 0, 0},
       {"goal_distance_bias", 2, 200, 1, 0},
       {"occdist_scale", 0.001, 0.3, 1, 0},
       {"forward_point_distance", 0, 0.8, 0, 0},
       {"footprint_padding", 0, 0.1, 0, 0},
       {"inflation_radius", 0.3, 1, 0, 0},
       {"cost_scaling_factor", 1, 30, 1, 0}});
}

const slalom_parameters_api* slalom_method_get_parameters_api(void) {
  return reactive::Plugin<dwa_local_planner::DwaLocalPlanner>::parameters_table();
}
