// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/references/reference.h>
#include <slalom/robot/robot_model.h>

#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// Section [reference].
struct OmplOptions {
  std::string planner = kExactPlanner;  ///< one of planner_names()
  ReferencePlanner::Objective objective = ReferencePlanner::Objective::Length;
  double gap = 0.01;               ///< relative gap to the bound of the exact search
  int max_iterations = 20000;      ///< maximum iterations of the planner
  int max_pose_iterations = 1000;  ///< the same for planning poses, which is slower
  double max_time = 10;  ///< s, wall-clock limit; results are not repeatable if it is reached

  void visit(OptionVisitor& v);
};

/// kExactPlanner and the planners of OMPL.
std::vector<std::string> planner_names();

/// Creates the planner with this name for a robot.
///
/// For a disc that can rotate in place: null for kExactPlanner, whose path is already the shortest;
/// else OMPL's planner in R^2, with exact checks of states and motions.
///
/// For other robots it plans poses: Dubins or Reeds-Shepp curves with a minimum turning radius;
/// polygons rotate in place and drive straight, holonomic ones while they rotate. Of polygons that
/// rotate in place find_footprint_path(); if that is not within the gap of lower_bound(), the
/// shortest path on a roadmap along exact shortest paths of discs; then OMPL's planner, which
/// samples the poses of the shorter path first (RRTstar for kExactPlanner, for polygons only with
/// the objective Clearance). All are smoothed, and the shortest is returned. lower_bound() is
/// turning_lower_bound(), or for polygons that rotate in place that of the inscribed disc.
///
/// The objective is the path length or the bottleneck clearance; the planner stops when its path is
/// within the gap of the bound. Repeatable if each plan() is called in a process that has not used
/// OMPL before: its random generators are seeded once per process.
std::unique_ptr<ReferencePlanner> make_ompl_planner(const OmplOptions& options,
                                                    const RobotModel& robot = {});

std::string ompl_version();

}  // namespace slalom
