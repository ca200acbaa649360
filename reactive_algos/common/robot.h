#pragma once

#include <slalom/methods/slalom_method.h>

#include <algorithm>
#include <cmath>

namespace reactive {

/// What a method must know of the robot and its sensor. A polygon counts as the disc around it.
struct Robot {
  double radius = 0.25;  ///< m
  double max_v = 1, max_w = 1.5;
  double max_accel_v = 1, max_accel_w = 3;
  double aperture = 3.141592653589793;  ///< rad, of the scan
  double max_range = 8;                 ///< m
};

inline Robot robot_of(const slalom_robot& robot) {
  return {robot.radius,      robot.max_v,    robot.max_w,    robot.max_accel_v,
          robot.max_accel_w, robot.aperture, robot.max_range};
}

/// Speeds ahead (m/s) and of turning (rad/s).
struct Speeds {
  double v = 0, w = 0;
};

/// Share of the largest deceleration that plans count on; the rest is for what they did not see.
constexpr double kBrakingShare = 0.7;

/// The speed from which the robot can stop within `way`, m/s.
inline double stopping_speed(double way, const Robot& robot) {
  return std::sqrt(2 * kBrakingShare * robot.max_accel_v * std::max(0.0, way));
}

/// The turning speed that can be stopped within `angle`, with its sign.
inline double turning_speed(double angle, const Robot& robot) {
  const double w = std::sqrt(2 * kBrakingShare * robot.max_accel_w * std::abs(angle));
  return std::copysign(std::min(w, robot.max_w), angle);
}

/// The commands nearest to `speeds` that the robot takes; it never drives backwards.
inline Speeds limited(const Speeds& speeds, const Robot& robot) {
  return {std::clamp(speeds.v, 0.0, robot.max_v), std::clamp(speeds.w, -robot.max_w, robot.max_w)};
}

}  // namespace reactive
