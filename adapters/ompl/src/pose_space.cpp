#include "planning_space.h"

#include <slalom/simulation/footprint_contact.h>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

namespace ob = ompl::base;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr int kGoalHeadings = 16;

TPose2D pose_of(const ob::State* state) {
  const auto* pose = state->as<ob::SE2StateSpace::StateType>();
  return {pose->getX(), pose->getY(), pose->getYaw()};
}

void set_pose(ob::State* state, const TPoint2D& point, double heading) {
  auto* pose = state->as<ob::SE2StateSpace::StateType>();
  pose->setXY(point.x, point.y);
  const double yaw = std::remainder(heading, 2 * M_PI);
  pose->setYaw(yaw < M_PI ? yaw : -M_PI);  // OMPL's headings lie in [-pi, pi)
}

class PoseValidityChecker : public ob::StateValidityChecker {
 public:
  PoseValidityChecker(const ob::SpaceInformationPtr& space, const World& world,
                      const Footprint& footprint)
      : ob::StateValidityChecker(space),
        world_(world),
        contact_(make_footprint_contact(world, footprint)) {
    specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
  }
  bool isValid(const ob::State* state) const override {
    const TPose2D pose = pose_of(state);
    return world_.scenario().bounds().contains({pose.x, pose.y}) && !contact_->touches(pose);
  }
  double clearance(const ob::State* state) const override {
    const TPose2D pose = pose_of(state);
    return world_.distance_field().clearance({pose.x, pose.y});
  }

 private:
  const World& world_;
  std::unique_ptr<FootprintContact> contact_;
};

/// Checks curved motions along chords between successive poses.
class PoseMotionValidator : public ob::MotionValidator {
 public:
  PoseMotionValidator(const ob::SpaceInformationPtr& space, const World& world,
                      const Footprint& footprint, double max_step)
      : ob::MotionValidator(space), world_(world), footprint_(footprint), max_step_(max_step) {}

  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    std::pair<ob::State*, double> unused(nullptr, 0);
    return checkMotion(a, b, unused);
  }
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last_valid) const override {
    const auto contact = make_footprint_contact(world_, footprint_);
    const auto& space = *si_->getStateSpace();
    const int steps = std::max(1, static_cast<int>(std::ceil(space.distance(a, b) / max_step_)));
    ob::ScopedState<> next(si_->getStateSpace());
    TPose2D from = pose_of(a);
    for (int i = 1; i <= steps; ++i) {
      space.interpolate(a, b, static_cast<double>(i) / steps, next.get());
      TPose2D to = pose_of(next.get());
      double fraction = 1;
      if (contact->find_contact(from, to, fraction)) {
        last_valid.second = static_cast<double>(i - 1) / steps;
        if (last_valid.first != nullptr)
          space.interpolate(a, b, last_valid.second, last_valid.first);
        return false;
      }
      from = to;
    }
    return true;
  }

 private:
  const World& world_;
  Footprint footprint_;
  double max_step_;
};

std::shared_ptr<ob::SE2StateSpace> make_state_space(const RobotModel& robot) {
  if (robot.min_turning_radius > 0 && robot.forward_only)
    return std::make_shared<ob::DubinsStateSpace>(robot.min_turning_radius);
  if (robot.min_turning_radius > 0)
    return std::make_shared<ob::ReedsSheppStateSpace>(robot.min_turning_radius);
  auto poses = std::make_shared<ob::SE2StateSpace>();
  poses->setSubspaceWeight(1, 0.01);  // rotation in place is nearly free: length dominates
  return poses;
}

ob::GoalPtr goal_in_any_heading(const ob::SpaceInformationPtr& information, const TPoint2D& goal) {
  auto goals = std::make_shared<ob::GoalStates>(information);
  for (int i = 0; i < kGoalHeadings; ++i) {
    ob::ScopedState<> state(information);
    set_pose(state.get(), goal, 2 * M_PI * i / kGoalHeadings);
    if (information->isValid(state.get())) goals->addState(state);
  }
  return goals;
}

}  // namespace

PlanningSpace make_pose_space(const PlanningProblem& problem, const RobotModel& robot) {
  const auto poses = make_state_space(robot);
  poses->setBounds(planning_bounds(problem.world));

  const double max_step = 0.5 * problem.world.occupancy().resolution();
  PlanningSpace space;
  space.information = std::make_shared<ob::SpaceInformation>(poses);
  space.information->setStateValidityChecker(
      std::make_shared<PoseValidityChecker>(space.information, problem.world, robot.shape()));
  space.information->setMotionValidator(std::make_shared<PoseMotionValidator>(
      space.information, problem.world, robot.shape(), max_step));
  space.information->setup();
  space.set_start = [start = problem.start, heading = problem.start_heading](ob::State* state) {
    set_pose(state, start, heading);
  };
  space.goal = goal_in_any_heading(space.information, problem.goal);
  space.to_path = [max_step](const ob::PathPtr& solution) {
    auto curve = *solution->as<ompl::geometric::PathGeometric>();
    curve.interpolate(
        std::max<unsigned>(2, static_cast<unsigned>(std::ceil(curve.length() / max_step))));
    Path path;
    for (const ob::State* state : curve.getStates()) {
      const TPose2D pose = pose_of(state);
      path.emplace_back(pose.x, pose.y);
    }
    return path;
  };
  return space;
}

}  // namespace slalom
