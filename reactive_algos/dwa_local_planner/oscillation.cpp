// SPDX-License-Identifier: BSD-3-Clause
#include "dwa_local_planner/oscillation.h"

#include <slalom/core/math.h>

namespace dwa_local_planner {

using namespace reactive;

namespace {

int sign_of(double value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

}  // namespace

bool OscillationCritic::allows(const Twist& twist) const {
  return forward_.only * sign_of(twist.v) >= 0 && rotation_.only * sign_of(twist.w) >= 0;
}

void OscillationCritic::commanded(const Twist& twist, const Pose& pose) {
  const int forward = forward_.only, rotation = rotation_.only;
  forward_.move(sign_of(twist.v));
  if (std::abs(twist.v) <= min_vel_trans_) rotation_.move(sign_of(twist.w));
  if (forward_.only != forward || rotation_.only != rotation) {
    reversed_at_ = pose;
    return;
  }
  if (forward == 0 && rotation == 0) return;
  const double moved = slalom::math::hypot(pose.x - reversed_at_.x, pose.y - reversed_at_.y);
  const double turned = std::abs(wrapped(pose.phi - reversed_at_.phi));
  if (moved > reset_dist_ || turned > reset_angle_) reset();
}

}  // namespace dwa_local_planner
