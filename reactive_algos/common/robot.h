// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/geometry.h"

#include <slalom/core/math.h>
#include <slalom/methods/slalom_method.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace reactive {

/// One of the discs that cover a footprint.
struct FootprintDisc {
  Point center;      ///< robot frame
  double inset = 0;  ///< m, by which its radius is smaller than Robot::radius
};

/// Robot and sensor parameters of a method.
struct Robot {
  double radius =
      0.25;  ///< m, of the disc that contains the footprint; see also with_cover_discs()
  double max_v = 1, max_w = 1.5;
  double max_accel_v = 1, max_accel_w = 3;
  double aperture = M_PI;  ///< rad, of the scan
  double max_range = 8;    ///< m
  bool forward_only = true;
  std::vector<Point> footprint = {};        ///< convex, m, counter-clockwise; empty: the disc
  std::vector<FootprintDisc> discs = {{}};  ///< their union contains the footprint

  bool is_disc() const { return discs.size() == 1; }
  /// Distance from the origin to the farthest center of a disc, m.
  double reach() const {
    double result = 0;
    for (const FootprintDisc& disc : discs)
      result = std::max(result, slalom::math::hypot(disc.center.x, disc.center.y));
    return result;
  }
};

inline Robot robot_of(const slalom_robot& robot) {
  Robot result = {robot.radius,      robot.max_v,    robot.max_w,     robot.max_accel_v,
                  robot.max_accel_w, robot.aperture, robot.max_range, robot.forward_only != 0};
  for (std::size_t i = 0; i < robot.footprint_points; ++i)
    result.footprint.push_back({robot.footprint[2 * i], robot.footprint[2 * i + 1]});
  return result;
}

/// The radius (m) of the largest disc around the origin within the footprint.
inline double inscribed_radius(const Robot& robot) {
  double result = robot.radius;
  for (std::size_t i = 0; i < robot.footprint.size(); ++i) {
    const Point& a = robot.footprint[i];
    const Point& b = robot.footprint[(i + 1) % robot.footprint.size()];
    // The distance to the edge's line, which for a convex footprint is that to the edge.
    result = std::min(result, std::abs(a.x * b.y - b.x * a.y) / distance(a, b));
  }
  return result;
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
