// SPDX-License-Identifier: BSD-3-Clause
#include "dwa/dwa.h"

const slalom_method_api* slalom_method_get_api(void) {
  return reactive::Plugin<dwa::Dwa>::table("dwa");
}

const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void) {
  return reactive::Plugin<dwa::Dwa>::goal_heading_table();
}

// Ratios of the weights decide: alpha is left out.
const slalom_space_api* slalom_method_get_space_api(void) {
  return reactive::Plugin<dwa::Dwa>::space_table({{"beta", 0.02, 2, 1, 0},
                                                  {"gamma", 0.03, 3, 1, 0},
                                                  {"margin", 0, 0.2, 0, 0},
                                                  {"horizon", 0.5, 6, 1, 0},
                                                  {"v_samples", 5, 21, 0, 1},
                                                  {"w_samples", 21, 61, 0, 1},
                                                  {"turn_in_place", 0.5, 3, 0, 0}});
}

const slalom_parameters_api* slalom_method_get_parameters_api(void) {
  return reactive::Plugin<dwa::Dwa>::parameters_table();
}
