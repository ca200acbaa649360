// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pose_motions.h"

#include <slalom/references/reference.h>

#include <ompl/base/Goal.h>
#include <ompl/base/Path.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorBounds.h>

#include <functional>
#include <vector>

namespace slalom {

/// The search space of a planner: its states with validity checks of states and motions, start,
/// goal, and the conversion of a solution to a path of positions.
struct PlanningSpace {
  ompl::base::SpaceInformationPtr information;
  std::function<void(ompl::base::State*)> set_start;
  ompl::base::GoalPtr goal;
  std::function<Path(const ompl::base::PathPtr&)> to_path;
};

/// Returns the bounds of the workspace.
ompl::base::RealVectorBounds planning_bounds(const World& world);

/// R^2 for the disc of problem.robot_radius. States and straight motions are checked exactly, with
/// the collision model of the simulation, without sampling of motions.
PlanningSpace make_point_space(const PlanningProblem& problem);

/// Poses (x, y, heading) for a robot whose heading matters, with its motions, which must outlive
/// the space: SE(2), Dubins or Reeds-Shepp curves. The planner samples the poses `seeds` first.
/// Solutions are converted by poses_of(), not by to_path.
PlanningSpace make_pose_space(const PlanningProblem& problem, const PoseMotions& motions,
                              const std::vector<mrpt::math::TPose2D>& goals,
                              const std::vector<mrpt::math::TPose2D>& seeds);

std::vector<mrpt::math::TPose2D> poses_of(const ompl::base::PathPtr& solution);

}  // namespace slalom
