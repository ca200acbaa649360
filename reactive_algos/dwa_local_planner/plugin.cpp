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
