// SPDX-License-Identifier: BSD-3-Clause
#include "planner_list.h"

#include <slalom/ompl/ompl_planner.h>

namespace slalom {

void OmplOptions::visit(OptionVisitor& v) {
  v.option("planner", planner, "planner of the reference path; exact: only the exact search",
           planner_names());
  v.option("objective", objective, "reference provided by the planner: shortest or safest path");
  v.option("gap", gap, "-", "relative gap to the certified lower bound", Range::positive());
  v.option("max_iterations", max_iterations, "-", "maximum iterations of the planner",
           Range::at_least(1));
  v.option("max_pose_iterations", max_pose_iterations, "-",
           "the same for planning poses: polygons and car-like robots", Range::at_least(1));
  v.option("max_time", max_time, "s", "wall-clock limit of the planner", Range::positive());
}

std::vector<std::string> planner_names() {
  std::vector<std::string> names = {kExactPlanner};
  names.insert(names.end(), kOmplPlanners.begin(), kOmplPlanners.end());
  return names;
}

std::string ompl_version() {
  return SLALOM_OMPL_VERSION;
}

}  // namespace slalom
