// SPDX-License-Identifier: BSD-3-Clause
#include "regulated_pure_pursuit/regulated_pure_pursuit.h"

const slalom_method_api* slalom_method_get_api(void) {
  return reactive::Plugin<regulated_pure_pursuit::RegulatedPurePursuit>::table(
      "regulated_pure_pursuit");
}

const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void) {
  return reactive::Plugin<regulated_pure_pursuit::RegulatedPurePursuit>::goal_heading_table();
}
