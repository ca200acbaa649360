#pragma once

#include <slalom/methods/slalom_method.h>

#include <algorithm>
#include <cmath>

namespace reactive {

/// Robot and sensor parameters of a method. A polygon is replaced by its enclosing disc.
struct Robot {
  double radius = 0.25;  ///< m
  double max_v = 1, max_w = 1.5;
  double max_accel_v = 1, max_accel_w = 3;
  double aperture = M_PI;  ///< rad, of the scan
  double max_range = 8;    ///< m
};

inline Robot robot_of(const slalom_robot& robot) {
  return {robot.radius,      robot.max_v,    robot.max_w,    robot.max_accel_v,
          robot.max_accel_w, robot.aperture, robot.max_range};
}

/// Linear (m/s) and angular velocity (rad/s).
struct Twist {
  double v = 0, w = 0;
};

/// Fraction of the maximum deceleration that is used in plans; the rest is a reserve.
constexpr double kBrakingFraction = 0.7;

/// The speed from which the robot can stop within `braking_distance`, m/s.
inline double stopping_speed(double braking_distance, const Robot& robot) {
  return std::sqrt(2 * kBrakingFraction * robot.max_accel_v * std::max(0.0, braking_distance));
}

/// The signed angular velocity from which the robot can stop within `angle`.
inline double stopping_angular_velocity(double angle, const Robot& robot) {
  const double w = std::sqrt(2 * kBrakingFraction * robot.max_accel_w * std::abs(angle));
  return std::copysign(std::min(w, robot.max_w), angle);
}

/// Clamps `twist` to the robot's limits; v is never negative.
inline Twist clamp_to_limits(const Twist& twist, const Robot& robot) {
  return {std::clamp(twist.v, 0.0, robot.max_v), std::clamp(twist.w, -robot.max_w, robot.max_w)};
}

}  // namespace reactive
