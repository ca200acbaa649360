// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory_rollout/trajectory_rollout.h"

const slalom_method_api* slalom_method_get_api(void) {
  return reactive::Plugin<trajectory_rollout::TrajectoryRollout>::table("trajectory_rollout");
}

const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void) {
  return reactive::Plugin<trajectory_rollout::TrajectoryRollout>::goal_heading_table();
}

const slalom_space_api* slalom_method_get_space_api(void) {
  return reactive::Plugin<trajectory_rollout::TrajectoryRollout>::space_table(
      trajectory_rollout::tuning_ranges());
}

const slalom_parameters_api* slalom_method_get_parameters_api(void) {
  return reactive::Plugin<trajectory_rollout::TrajectoryRollout>::parameters_table();
}
