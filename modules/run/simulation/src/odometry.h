// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/robot/robot_model.h>

#include <mrpt/math/TPose2D.h>

namespace slalom {

/// The odometry of the robot: the true motion, or one that drifts from it as a random walk. The
/// error of a motion has the model's standard deviation times the square root of its length, so
/// drift does not depend on the length of the steps.
class Odometry {
 public:
  Odometry(const OdometryModel& model, std::uint64_t seed, const mrpt::math::TPose2D& start);

  /// The robot moved from `from` to `to` (true poses, m and rad).
  void move(const mrpt::math::TPose2D& from, const mrpt::math::TPose2D& to);
  const mrpt::math::TPose2D& pose() const { return pose_; }

 private:
  OdometryModel model_;
  RandomEngine distance_, turn_;
  mrpt::math::TPose2D pose_;
};

}  // namespace slalom
