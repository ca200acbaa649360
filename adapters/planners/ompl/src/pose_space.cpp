// SPDX-License-Identifier: BSD-3-Clause
#include "dubins_curve.h"
#include "planning_space.h"
#include "pose_states.h"

#include <slalom/core/math.h>

#include <mrpt/math/wrap2pi.h>
#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateSampler.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

namespace ob = ompl::base;
using mrpt::math::TPose2D;
using mrpt::math::wrapToPi;

constexpr double kRotationWeight = 0.01;  // m/rad: rotation in place is nearly free

class PoseValidityChecker : public ob::StateValidityChecker {
 public:
  PoseValidityChecker(const ob::SpaceInformationPtr& space, const PoseMotions& motions)
      : ob::StateValidityChecker(space), motions_(motions) {
    specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
  }
  bool isValid(const ob::State* state) const override {
    return motions_.is_free_at(pose_of(state));
  }
  double clearance(const ob::State* state) const override {
    const TPose2D pose = pose_of(state);
    return motions_.world().distance_field().clearance({pose.x, pose.y});
  }

 private:
  const PoseMotions& motions_;
};

class PoseMotionValidator : public ob::MotionValidator {
 public:
  PoseMotionValidator(const ob::SpaceInformationPtr& space, const PoseMotions& motions)
      : ob::MotionValidator(space), motions_(motions) {}

  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return motions_.is_free(pose_of(a), pose_of(b));
  }
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (motions_.is_free(pose_of(a), pose_of(b), last_valid.second)) return true;
    if (last_valid.first != nullptr)
      si_->getStateSpace()->interpolate(a, b, last_valid.second, last_valid.first);
    return false;
  }

 private:
  const PoseMotions& motions_;
};

/// SE(2) for a robot that rotates in place, drives straight and rotates again.
class RotateAndDriveSpace : public ob::SE2StateSpace {
 public:
  explicit RotateAndDriveSpace(bool forward_only) : forward_only_(forward_only) {}

  bool isMetricSpace() const override { return false; }
  bool hasSymmetricDistance() const override { return !forward_only_; }
  bool hasSymmetricInterpolate() const override { return !forward_only_; }

  double distance(const ob::State* a, const ob::State* b) const override {
    const auto parts = lengths(rotate_and_drive(pose_of(a), pose_of(b), forward_only_));
    return parts[0] + parts[1] + parts[2];
  }
  void interpolate(const ob::State* a, const ob::State* b, double t,
                   ob::State* state) const override {
    const auto poses = rotate_and_drive(pose_of(a), pose_of(b), forward_only_);
    const auto parts = lengths(poses);
    double left = t * (parts[0] + parts[1] + parts[2]);
    std::size_t i = 0;
    for (; i < 2 && left > parts[i]; ++i) left -= parts[i];
    const double fraction = parts[i] > 0 ? std::min(1.0, left / parts[i]) : 1;
    const TPose2D &from = poses[i], &to = poses[i + 1];
    set_pose(state, {from.x + fraction * (to.x - from.x), from.y + fraction * (to.y - from.y),
                     from.phi + fraction * wrapToPi(to.phi - from.phi)});
  }

 private:
  static std::array<double, 3> lengths(const std::array<TPose2D, 4>& poses) {
    const auto rotation = [&](int i) {
      return kRotationWeight * std::abs(wrapToPi(poses[i + 1].phi - poses[i].phi));
    };
    return {rotation(0), math::hypot(poses[2].x - poses[1].x, poses[2].y - poses[1].y),
            rotation(2)};
  }

  bool forward_only_;
};

class DubinsSpace : public ob::DubinsStateSpace {
 public:
  explicit DubinsSpace(double radius) : ob::DubinsStateSpace(radius) {}

  double distance(const ob::State* a, const ob::State* b) const override {
    return DubinsCurve(pose_of(a), pose_of(b), rho_).length();
  }
  void interpolate(const ob::State* a, const ob::State* b, double t,
                   ob::State* state) const override {
    set_pose(state, DubinsCurve(pose_of(a), pose_of(b), rho_).at(t));
  }
};

std::shared_ptr<ob::SE2StateSpace> make_state_space(const RobotModel& robot) {
  if (robot.min_turning_radius > 0 && robot.forward_only)
    return std::make_shared<DubinsSpace>(robot.min_turning_radius);
  if (robot.min_turning_radius > 0)
    return std::make_shared<ob::ReedsSheppStateSpace>(robot.min_turning_radius);
  if (!robot.holonomic()) return std::make_shared<RotateAndDriveSpace>(robot.forward_only);
  auto poses = std::make_shared<ob::SE2StateSpace>();
  poses->setSubspaceWeight(1, kRotationWeight);
  return poses;
}

/// First the poses of a path that is known, then what the space samples itself.
class SeededSampler : public ob::StateSampler {
 public:
  SeededSampler(const ob::StateSpace* space, std::vector<TPose2D> seeds)
      : ob::StateSampler(space),
        rest_(space->allocDefaultStateSampler()),
        seeds_(std::move(seeds)) {}

  void sampleUniform(ob::State* state) override {
    if (next_ < seeds_.size())
      set_pose(state, seeds_[next_++]);
    else
      rest_->sampleUniform(state);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    rest_->sampleUniformNear(state, near, distance);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    rest_->sampleGaussian(state, mean, deviation);
  }

 private:
  ob::StateSamplerPtr rest_;
  std::vector<TPose2D> seeds_;
  std::size_t next_ = 0;
};

}  // namespace

PlanningSpace make_pose_space(const PlanningProblem& problem, const PoseMotions& motions,
                              const std::vector<TPose2D>& goals,
                              const std::vector<TPose2D>& seeds) {
  const auto poses = make_state_space(motions.robot());
  poses->setBounds(planning_bounds(problem.world));
  poses->setStateSamplerAllocator([seeds](const ob::StateSpace* space) {
    return std::make_shared<SeededSampler>(space, seeds);
  });
  PlanningSpace space;
  space.information = std::make_shared<ob::SpaceInformation>(poses);
  space.information->setStateValidityChecker(
      std::make_shared<PoseValidityChecker>(space.information, motions));
  space.information->setMotionValidator(
      std::make_shared<PoseMotionValidator>(space.information, motions));
  space.information->setup();
  space.set_start = [&problem](ob::State* state) {
    set_pose(state, {problem.start.x, problem.start.y, problem.start_heading});
  };
  auto goal = std::make_shared<ob::GoalStates>(space.information);
  for (const TPose2D& pose : goals) {
    ob::ScopedState<> state(space.information);
    set_pose(state.get(), pose);
    goal->addState(state);
  }
  space.goal = goal;
  return space;
}

std::vector<TPose2D> poses_of(const ob::PathPtr& solution) {
  std::vector<TPose2D> poses;
  for (const ob::State* state : solution->as<ompl::geometric::PathGeometric>()->getStates())
    poses.push_back(pose_of(state));
  return poses;
}

}  // namespace slalom
