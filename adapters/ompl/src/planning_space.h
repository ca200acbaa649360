#pragma once

#include <slalom/references/reference.h>
#include <slalom/robot/robot_model.h>

#include <ompl/base/Goal.h>
#include <ompl/base/Path.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorBounds.h>

#include <functional>
#include <memory>

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

/// Poses (x, y, heading) for a robot whose heading matters: SE(2) for a polygon that can rotate in
/// place, Dubins curves for a forward-only robot with a minimum turning radius, Reeds-Shepp curves
/// if it can reverse. The goal has 16 headings. Motions are checked along chords of at most half a
/// cell, with the collision test of the simulation.
PlanningSpace make_pose_space(const PlanningProblem& problem, const RobotModel& robot);

}  // namespace slalom
