// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory_rollout/trajectory_rollout.h"

using Method = reactive::Plugin<trajectory_rollout::TrajectoryRollout>;

const slalom_method_api* slalom_method_get_api(void) {
  return Method::table("rollout_tracks");
}

const slalom_tracks_api* slalom_method_get_tracks_api(void) {
  return Method::tracks_table();
}

const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void) {
  return Method::goal_heading_table();
}

const slalom_space_api* slalom_method_get_space_api(void) {
  return Method::space_table(trajectory_rollout::tuning_ranges());
}

const slalom_parameters_api* slalom_method_get_parameters_api(void) {
  return Method::parameters_table();
}
