// SPDX-License-Identifier: BSD-3-Clause
#include "eband_local_planner/follow_band.h"

#include <slalom/core/math.h>

#include <algorithm>

namespace eband_local_planner {

using namespace reactive;

namespace {

/// Fraction of a bubble's radius that counts in eband_local_planner, for the angle within which the
/// robot moves and for the speed.
constexpr double kUsedRadius = 0.7;

double with_magnitude_in(double value, double low, double high) {
  return std::copysign(std::min(std::max(std::abs(value), low), high), value);
}

}  // namespace

Twist follow(const std::vector<Bubble>& band, const Pose& pose,
             const ControllerParameters& parameters) {
  const Bubble& next = band[1];
  const Point target = to_robot(pose, next.center);
  const double bearing = slalom::math::atan2(target.y, target.x);
  const double w = parameters.k_prop * bearing;
  const double threshold =
      parameters.rotation_threshold_multiplier *
      slalom::math::atan2(kUsedRadius * next.radius, slalom::math::hypot(target.x, target.y));
  if (std::abs(bearing) > threshold)
    return {0, with_magnitude_in(w, parameters.min_in_place_vel_th, parameters.max_vel_th)};
  const double v = parameters.bubble_velocity_multiplier * kUsedRadius * band[0].radius *
                   parameters.max_vel_lin * slalom::math::cos(bearing);
  return {std::min(std::max(v, parameters.min_vel_lin), parameters.max_vel_lin),
          with_magnitude_in(w, parameters.min_vel_th, parameters.max_vel_th)};
}

}  // namespace eband_local_planner
