// SPDX-License-Identifier: BSD-3-Clause
#include "odometry.h"

#include <slalom/core/math.h>

#include <mrpt/math/wrap2pi.h>

#include <cmath>

namespace slalom {

using mrpt::math::TPose2D;

Odometry::Odometry(const OdometryModel& model, std::uint64_t seed, const TPose2D& start)
    : model_(model),
      distance_(derive_seed(seed, "odometry/distance")),
      turn_(derive_seed(seed, "odometry/turn")),
      pose_(start) {}

void Odometry::move(const TPose2D& from, const TPose2D& to) {
  if (model_.distance_sigma == 0 && model_.turn_sigma == 0) {
    pose_ = to;
    return;
  }
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double turn = mrpt::math::wrapToPi(to.phi - from.phi), length = math::hypot(dx, dy);
  const double distance_error =
      length > 0 && model_.distance_sigma > 0
          ? normal(distance_, 0, model_.distance_sigma * std::sqrt(length))
          : 0;
  const double turn_error =
      model_.turn_sigma > 0 ? normal(turn_, 0, model_.turn_sigma * std::sqrt(std::abs(turn))) : 0;
  const double scale = length > 0 ? 1 + distance_error / length : 1;
  // The measured motion, applied to the odometry pose.
  const auto [s, c] = math::sin_cos(pose_.phi - from.phi);
  pose_ = {pose_.x + scale * (c * dx - s * dy), pose_.y + scale * (s * dx + c * dy),
           mrpt::math::wrapToPi(pose_.phi + turn + turn_error)};
}

}  // namespace slalom
