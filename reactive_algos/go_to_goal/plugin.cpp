// SPDX-License-Identifier: BSD-3-Clause
#include "go_to_goal/go_to_goal.h"

const slalom_method_api* slalom_method_get_api(void) {
  return reactive::Plugin<go_to_goal::GoToGoal>::table("go_to_goal");
}

const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void) {
  return reactive::Plugin<go_to_goal::GoToGoal>::goal_heading_table();
}

const slalom_space_api* slalom_method_get_space_api(void) {
  return reactive::Plugin<go_to_goal::GoToGoal>::space_table({{"turn_in_place", 0.3, 3, 0, 0}});
}

const slalom_parameters_api* slalom_method_get_parameters_api(void) {
  return reactive::Plugin<go_to_goal::GoToGoal>::parameters_table();
}
