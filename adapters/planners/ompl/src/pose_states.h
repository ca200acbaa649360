// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPose2D.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <cmath>

namespace slalom {

inline mrpt::math::TPose2D pose_of(const ompl::base::State* state) {
  const auto* pose = state->as<ompl::base::SE2StateSpace::StateType>();
  return {pose->getX(), pose->getY(), pose->getYaw()};
}

inline void set_pose(ompl::base::State* state, const mrpt::math::TPose2D& value) {
  auto* pose = state->as<ompl::base::SE2StateSpace::StateType>();
  pose->setXY(value.x, value.y);
  const double yaw = std::remainder(value.phi, 2 * M_PI);
  pose->setYaw(yaw < M_PI ? yaw : -M_PI);  // OMPL's headings lie in [-pi, pi)
}

}  // namespace slalom
