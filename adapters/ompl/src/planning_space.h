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

/// Where a planner looks for a path: states, which of them and which motions between them are free,
/// and how a solution reads as a path of positions.
struct PlanningSpace {
  ompl::base::SpaceInformationPtr information;
  std::function<void(ompl::base::State*)> set_start;
  ompl::base::GoalPtr goal;
  std::function<Path(const ompl::base::PathPtr&)> to_path;
};

/// The workspace, as OMPL takes it.
ompl::base::RealVectorBounds planning_bounds(const World& world);

/// R^2 for the disc of problem.robot_radius. States and straight motions are tested exactly in the
/// model that judges collisions, with no sampling of motions.
PlanningSpace make_point_space(const PlanningProblem& problem);

/// Poses (x, y, heading) for a robot whose heading matters: SE(2) for a polygon that turns on the
/// spot, Dubins curves for one that drives forward only with a smallest turning radius, Reeds-Shepp
/// curves if it may reverse. The goal may be reached in any of 16 headings. Motions are tested
/// along chords of at most half a cell by the judge's own test.
PlanningSpace make_pose_space(const PlanningProblem& problem, const RobotModel& robot);

}  // namespace slalom
