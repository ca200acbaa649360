// SPDX-License-Identifier: BSD-3-Clause
#include "dwa/dwa.h"

const slalom_method_api* slalom_method_get_api(void) {
  return reactive::Plugin<dwa::Dwa>::table("dwa");
}

const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void) {
  return reactive::Plugin<dwa::Dwa>::goal_heading_table();
}
