// SPDX-License-Identifier: BSD-3-Clause
#include "planning_space.h"

#include <slalom/ompl/disc_checks.h>

#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

namespace slalom {
namespace {

namespace ob = ompl::base;
using mrpt::math::TPoint2D;

void set_point(ob::State* state, const TPoint2D& point) {
  auto* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  values[0] = point.x;
  values[1] = point.y;
}

}  // namespace

ob::RealVectorBounds planning_bounds(const World& world) {
  const Bounds bounds = world.occupancy().bounds();
  ob::RealVectorBounds limits(2);
  limits.setLow(0, bounds.x_min);
  limits.setHigh(0, bounds.x_max);
  limits.setLow(1, bounds.y_min);
  limits.setHigh(1, bounds.y_max);
  return limits;
}

PlanningSpace make_point_space(const PlanningProblem& problem) {
  PlanningSpace space;
  space.information = make_disc_space(problem.world, problem.robot_radius);
  space.set_start = [start = problem.start](ob::State* state) { set_point(state, start); };
  auto goal = std::make_shared<ob::GoalState>(space.information);
  ob::ScopedState<> at_goal(space.information);
  set_point(at_goal.get(), problem.goal);
  goal->setState(at_goal);
  space.goal = goal;
  space.to_path = [plane = space.information->getStateSpace()](const ob::PathPtr& solution) {
    Path path;
    for (const ob::State* state : solution->as<ompl::geometric::PathGeometric>()->getStates())
      path.push_back(position_of(*plane, state));
    return path;
  };
  return space;
}

}  // namespace slalom
