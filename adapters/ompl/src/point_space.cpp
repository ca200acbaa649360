#include "planning_space.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

namespace slalom {
namespace {

namespace ob = ompl::base;
using mrpt::math::TPoint2D;

TPoint2D point_of(const ob::State* state) {
  const auto* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  return {values[0], values[1]};
}

void set_point(ob::State* state, const TPoint2D& point) {
  auto* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  values[0] = point.x;
  values[1] = point.y;
}

class PointValidityChecker : public ob::StateValidityChecker {
 public:
  PointValidityChecker(const ob::SpaceInformationPtr& space, const PlanningProblem& problem)
      : ob::StateValidityChecker(space), problem_(problem) {
    specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
  }
  bool isValid(const ob::State* state) const override {
    return is_free(problem_.world, {point_of(state)}, problem_.robot_radius);
  }
  double clearance(const ob::State* state) const override {
    return problem_.world.distance_field().clearance(point_of(state));
  }

 private:
  const PlanningProblem& problem_;
};

class PointMotionValidator : public ob::MotionValidator {
 public:
  PointMotionValidator(const ob::SpaceInformationPtr& space, const PlanningProblem& problem)
      : ob::MotionValidator(space), problem_(problem) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return is_free(problem_.world, {point_of(a), point_of(b)}, problem_.robot_radius);
  }
  /// Also finds the last valid state, by bisection.
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(a, b)) return true;
    const TPoint2D from = point_of(a), to = point_of(b);
    double low = 0, high = 1;
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (low + high);
      const bool free =
          is_free(problem_.world, {from, from + (to - from) * middle}, problem_.robot_radius);
      (free ? low : high) = middle;
    }
    last_valid.second = low;
    if (last_valid.first != nullptr) si_->getStateSpace()->interpolate(a, b, low, last_valid.first);
    return false;
  }

 private:
  const PlanningProblem& problem_;
};

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
  auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  plane->setBounds(planning_bounds(problem.world));
  PlanningSpace space;
  space.information = std::make_shared<ob::SpaceInformation>(plane);
  space.information->setStateValidityChecker(
      std::make_shared<PointValidityChecker>(space.information, problem));
  space.information->setMotionValidator(
      std::make_shared<PointMotionValidator>(space.information, problem));
  space.information->setup();
  space.set_start = [start = problem.start](ob::State* state) { set_point(state, start); };
  auto goal = std::make_shared<ob::GoalState>(space.information);
  ob::ScopedState<> at_goal(space.information);
  set_point(at_goal.get(), problem.goal);
  goal->setState(at_goal);
  space.goal = goal;
  space.to_path = [](const ob::PathPtr& solution) {
    Path path;
    for (const ob::State* state : solution->as<ompl::geometric::PathGeometric>()->getStates())
      path.push_back(point_of(state));
    return path;
  };
  return space;
}

}  // namespace slalom
