// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/world.h>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

namespace slalom {

/// The position of a state of R^2 or SE(2) (m).
mrpt::math::TPoint2D position_of(const ompl::base::StateSpace& space,
                                 const ompl::base::State* state);

/// Whether a disc (m) may be at the position of a state of R^2 or SE(2), exactly as the simulation
/// checks collisions. The world must outlive it.
class DiscValidityChecker : public ompl::base::StateValidityChecker {
 public:
  DiscValidityChecker(const ompl::base::SpaceInformationPtr& space, const World& world,
                      double radius);

  bool isValid(const ompl::base::State* state) const override;
  double clearance(const ompl::base::State* state) const override;  ///< of the position, m

  const World& world() const { return world_; }
  double radius() const { return radius_; }  ///< m

 private:
  const World& world_;
  double radius_;
};

/// Sets the checks of states and of motions for a disc of `radius` (m) in `world`, which must
/// outlive them. Motions are straight, and checked exactly, without sampling. Throws
/// ompl::Exception if the space is neither R^2 nor SE(2); Dubins and Reeds-Shepp curves are not
/// straight.
void set_disc_checks(const ompl::base::SpaceInformationPtr& space, const World& world,
                     double radius);

/// R^2 with the bounds of the world and these checks.
ompl::base::SpaceInformationPtr make_disc_space(const World& world, double radius);

}  // namespace slalom
