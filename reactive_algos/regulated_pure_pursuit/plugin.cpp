// SPDX-License-Identifier: BSD-3-Clause
#include "regulated_pure_pursuit/regulated_pure_pursuit.h"

const slalom_method_api* slalom_method_get_api(void) {
  return reactive::Plugin<regulated_pure_pursuit::RegulatedPurePursuit>::table(
      "regulated_pure_pursuit");
}

const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void) {
  return reactive::Plugin<regulated_pure_pursuit::RegulatedPurePursuit>::goal_heading_table();
}

const slalom_space_api* slalom_method_get_space_api(void) {
  return reactive::Plugin<regulated_pure_pursuit::RegulatedPurePursuit>::space_table(
      {{"lookahead_time", 0.5, 4, 1, 0},
       {"min_lookahead_dist", 0.1, 0.6, 1, 0},
       {"max_lookahead_dist", 0.6, 2, 1, 0},
       {"regulated_linear_scaling_min_radius", 0.3, 2.7, 1, 0},
       {"regulated_linear_scaling_min_speed", 0.05, 0.5, 1, 0},
       {"cost_scaling_dist", 0.2, 1.5, 1, 0},
       {"max_allowed_time_to_collision_up_to_carrot", 0.3, 2.5, 1, 0},
       {"rotate_to_heading_min_angle", 0.4, 1.6, 0, 0},
       {"margin", 0, 0.15, 0, 0},
       {"comfort", 0.1, 1, 1, 0}});
}

const slalom_parameters_api* slalom_method_get_parameters_api(void) {
  return reactive::Plugin<regulated_pure_pursuit::RegulatedPurePursuit>::parameters_table();
}
