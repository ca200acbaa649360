// SPDX-License-Identifier: BSD-3-Clause
#include "eband_local_planner/eband_local_planner.h"

const slalom_method_api* slalom_method_get_api(void) {
  return reactive::Plugin<eband_local_planner::EbandLocalPlanner>::table("eband_local_planner");
}

const slalom_map_api* slalom_method_get_map_api(void) {
  return reactive::Plugin<eband_local_planner::EbandLocalPlanner>::map_table();
}

const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void) {
  return reactive::Plugin<eband_local_planner::EbandLocalPlanner>::goal_heading_table();
}

const slalom_space_api* slalom_method_get_space_api(void) {
  return reactive::Plugin<eband_local_planner::EbandLocalPlanner>::space_table(
      {{"eband_min_relative_overlap", 0.4, 0.9, 0, 0},
       {"eband_internal_force_gain", 0.2, 5, 1, 0},
       {"eband_external_force_gain", 0.4, 10, 1, 0},
       {"num_iterations_eband_optimization", 1, 6, 0, 1},
       {"costmap_weight", 4, 25, 1, 0},
       {"k_prop", 1, 8, 1, 0},
       {"bubble_velocity_multiplier", 0.7, 6, 1, 0},
       {"rotation_threshold_multiplier", 0.3, 3, 1, 0},
       {"footprint_padding", 0, 0.2, 0, 0},
       {"comfort", 0.05, 1, 1, 0}});
}

const slalom_parameters_api* slalom_method_get_parameters_api(void) {
  return reactive::Plugin<eband_local_planner::EbandLocalPlanner>::parameters_table();
}
