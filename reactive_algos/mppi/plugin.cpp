// SPDX-License-Identifier: BSD-3-Clause
#include "mppi/mppi.h"

const slalom_method_api* slalom_method_get_api(void) {
  return reactive::Plugin<mppi::Mppi>::table("mppi");
}

const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void) {
  return reactive::Plugin<mppi::Mppi>::goal_heading_table();
}

const slalom_space_api* slalom_method_get_space_api(void) {
  return reactive::Plugin<mppi::Mppi>::space_table({{"samples", 200, 800, 1, 1},
                                                    {"steps", 12, 36, 0, 1},
                                                    {"lambda", 0.03, 3, 1, 0},
                                                    {"noise_v", 0.05, 0.6, 1, 0},
                                                    {"noise_w", 0.2, 1.8, 1, 0},
                                                    {"hold", 1, 8, 0, 1},
                                                    {"margin", 0, 0.15, 0, 0},
                                                    {"comfort", 0.1, 1, 1, 0},
                                                    {"obstacle_weight", 0.3, 8, 1, 0},
                                                    {"goal_weight", 1, 16, 1, 0}});
}

const slalom_parameters_api* slalom_method_get_parameters_api(void) {
  return reactive::Plugin<mppi::Mppi>::parameters_table();
}
