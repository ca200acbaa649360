// SPDX-License-Identifier: BSD-3-Clause
#include "mppi/mppi.h"

const slalom_method_api* slalom_method_get_api(void) {
  return reactive::Plugin<mppi::Mppi>::table("mppi");
}

const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void) {
  return reactive::Plugin<mppi::Mppi>::goal_heading_table();
}
