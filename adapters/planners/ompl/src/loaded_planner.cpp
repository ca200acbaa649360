// SPDX-License-Identifier: BSD-3-Clause
// make_ompl_planner() for programs: OMPL is loaded when a robot or a planner needs it.
#include <slalom/library/part.h>
#include <slalom/ompl/ompl_planner.h>

namespace slalom {

std::unique_ptr<ReferencePlanner> make_ompl_planner(const OmplOptions& options,
                                                    const RobotModel& robot) {
  const bool is_disc = robot.min_turning_radius <= 0 && robot.shape().is_disc();
  if (is_disc && options.planner == kExactPlanner) return nullptr;
  const auto make = reinterpret_cast<ReferencePlanner* (*)(const OmplOptions&, const RobotModel&)>(
      find_in_part("ompl", "slalom_make_ompl_planner",
                   is_disc ? "[reference] planner = " + options.planner
                           : "reference paths of a robot that is not a disc or does not turn in "
                             "place"));
  return std::unique_ptr<ReferencePlanner>(make(options, robot));
}

}  // namespace slalom
