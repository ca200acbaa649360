// SPDX-License-Identifier: BSD-3-Clause
// Without OMPL: the exact search, and robots for which it is enough.
#include <slalom/core/version.h>
#include <slalom/ompl/ompl_planner.h>

namespace slalom {

std::vector<std::string> planner_names() {
  return {kExactPlanner};
}

std::unique_ptr<ReferencePlanner> make_ompl_planner(const OmplOptions&, const RobotModel& robot) {
  if (robot.min_turning_radius > 0 || !robot.shape().is_disc())
    throw not_built("reference paths of a robot that is not a disc or does not turn in place",
                    "SLALOM_WITH_OMPL");
  return nullptr;
}

std::string ompl_version() {
  return "none";
}

}  // namespace slalom
