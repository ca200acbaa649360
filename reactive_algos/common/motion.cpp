#include "common/motion.h"

#include <algorithm>

namespace reactive {

Pose integrate(const Pose& pose, const Twist& twist, double time) {
  const double turn = twist.w * time;
  // The chord of an arc: its direction is the middle heading, its length that of the arc times
  // sin(a) / a of half the turn.
  const double half = 0.5 * turn;
  const double chord = twist.v * time * (std::abs(half) < 1e-6 ? 1.0 : std::sin(half) / half);
  return {pose.x + chord * std::cos(pose.phi + half), pose.y + chord * std::sin(pose.phi + half),
          pose.phi + turn};
}

Twist apply_acceleration_limits(const Twist& from, const Twist& to, const Robot& robot,
                                double time) {
  const double dv = robot.max_accel_v * time, dw = robot.max_accel_w * time;
  return {std::clamp(to.v, from.v - dv, from.v + dv), std::clamp(to.w, from.w - dw, from.w + dw)};
}

double free_arc_length(const ClearanceMap& map, const Pose& pose, const Twist& twist, double radius,
                       double limit) {
  if (twist.v <= 0) return limit;
  constexpr double kMinStep = 0.02;  // m
  double length = 0;
  while (length < limit) {
    // Contact is not possible within the current clearance.
    const Pose at = integrate(pose, twist, length / twist.v);
    const double gap = map.at({at.x, at.y}) - radius;
    if (gap < 0) return length;
    length += std::max(gap, kMinStep);
  }
  return limit;
}

double clearance_radius(const ClearanceMap& map, const Pose& pose, const Robot& robot,
                        double margin) {
  constexpr double kMinMargin = 0.005;  // m beyond the radius
  const double here = map.at({pose.x, pose.y}) - kMinMargin;
  return std::clamp(here, robot.radius + kMinMargin, robot.radius + std::max(margin, kMinMargin));
}

bool RotateInPlace::update(double bearing) {
  if (side_ == 0 && std::abs(bearing) > begin_) side_ = bearing > 0 ? 1 : -1;
  if (std::abs(bearing) < end_) side_ = 0;
  // Change the side only if the bearing changes its sign in front of the robot.
  if (side_ * bearing < 0 && std::abs(bearing) < 0.5 * M_PI) side_ = bearing > 0 ? 1 : -1;
  return side_ != 0;
}

Twist RotateInPlace::twist(double bearing, const Robot& robot) const {
  const bool behind = side_ * bearing < 0;
  return {0, behind ? side_ * robot.max_w : stopping_angular_velocity(bearing, robot)};
}

}  // namespace reactive
