// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/ompl/ompl_planner.h>

extern "C" __attribute__((visibility("default"))) slalom::ReferencePlanner*
slalom_make_ompl_planner(const slalom::OmplOptions& options, const slalom::RobotModel& robot) {
  return slalom::make_ompl_planner(options, robot).release();
}
