// SPDX-License-Identifier: BSD-3-Clause
#include "planning_space.h"

#include <slalom/ompl/disc_checks.h>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Exception.h>

namespace slalom {
namespace {

namespace ob = ompl::base;
using mrpt::math::TPoint2D;

class DiscMotionValidator : public ob::MotionValidator {
 public:
  DiscMotionValidator(const ob::SpaceInformationPtr& space, const World& world, double radius)
      : ob::MotionValidator(space), world_(world), radius_(radius) {}

  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return is_free(world_, {position(a), position(b)}, radius_);
  }
  /// Also finds the last valid state, by bisection.
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(a, b)) return true;
    const TPoint2D from = position(a), to = position(b);
    double low = 0, high = 1;
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (low + high);
      const bool free = is_free(world_, {from, from + (to - from) * middle}, radius_);
      (free ? low : high) = middle;
    }
    last_valid.second = low;
    if (last_valid.first != nullptr) si_->getStateSpace()->interpolate(a, b, low, last_valid.first);
    return false;
  }

 private:
  TPoint2D position(const ob::State* state) const {
    return position_of(*si_->getStateSpace(), state);
  }

  const World& world_;
  double radius_;
};

/// Whether motions in it are straight lines of positions.
bool has_straight_motions(const ob::StateSpace& space) {
  if (space.getType() == ob::STATE_SPACE_REAL_VECTOR) return space.getDimension() == 2;
  return space.getType() == ob::STATE_SPACE_SE2 &&
         dynamic_cast<const ob::DubinsStateSpace*>(&space) == nullptr &&
         dynamic_cast<const ob::ReedsSheppStateSpace*>(&space) == nullptr;
}

}  // namespace

TPoint2D position_of(const ob::StateSpace& space, const ob::State* state) {
  if (space.getType() == ob::STATE_SPACE_REAL_VECTOR) {
    const auto* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    return {values[0], values[1]};
  }
  const auto* pose = state->as<ob::SE2StateSpace::StateType>();
  return {pose->getX(), pose->getY()};
}

DiscValidityChecker::DiscValidityChecker(const ob::SpaceInformationPtr& space, const World& world,
                                         double radius)
    : ob::StateValidityChecker(space), world_(world), radius_(radius) {
  specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
}

bool DiscValidityChecker::isValid(const ob::State* state) const {
  return is_free(world_, {position_of(*si_->getStateSpace(), state)}, radius_);
}

double DiscValidityChecker::clearance(const ob::State* state) const {
  return world_.distance_field().clearance(position_of(*si_->getStateSpace(), state));
}

void set_disc_checks(const ob::SpaceInformationPtr& space, const World& world, double radius) {
  if (!has_straight_motions(*space->getStateSpace()))
    throw ompl::Exception(
        "set_disc_checks()",
        "the state space is " + space->getStateSpace()->getName() + "; expected R^2 or SE(2)");
  space->setStateValidityChecker(std::make_shared<DiscValidityChecker>(space, world, radius));
  space->setMotionValidator(std::make_shared<DiscMotionValidator>(space, world, radius));
}

ob::SpaceInformationPtr make_disc_space(const World& world, double radius) {
  auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  plane->setBounds(planning_bounds(world));
  auto information = std::make_shared<ob::SpaceInformation>(plane);
  set_disc_checks(information, world, radius);
  information->setup();
  return information;
}

}  // namespace slalom
