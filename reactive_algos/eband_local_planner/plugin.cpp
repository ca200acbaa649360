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
