#pragma once

#include <slalom/core/options.h>
#include <slalom/references/reference.h>
#include <slalom/robot/robot_model.h>

#include <memory>
#include <string>

namespace slalom {

/// Section [reference].
struct OmplOptions {
  std::string planner = "InformedRRTstar";  ///< or exact: the exact search alone
  std::string objective = "length";         ///< or clearance: which reference it provides
  double gap = 0.01;                        ///< relative to the best that the exact search proves
  int max_iterations = 20000;               ///< of the planner, after which it gives up
  int max_pose_iterations = 1000;           ///< the same where it plans poses, which is slower
  double max_time = 10;  ///< s, a guard: a planner stopped by it is noted, not repeatable

  void visit(OptionVisitor& v);
};

/// OMPL's planner of that name for a robot. A disc that turns on the spot is planned for as a point
/// in R^2, with states and motions tested exactly; other robots as poses: Dubins or Reeds-Shepp
/// curves where it has a smallest turning radius, SE(2) for polygons. The objective is path length
/// or the bottleneck; the planner stops when its path is within the gap of what the exact search
/// proves. Null for "exact". Repeatable when each plan() is called in a process that has not used
/// OMPL before: its random generators are seeded once per process.
std::unique_ptr<ReferencePlanner> make_ompl_planner(const OmplOptions& options,
                                                    const RobotModel& robot = {});

std::string ompl_version();

}  // namespace slalom
