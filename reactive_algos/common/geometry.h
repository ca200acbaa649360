// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/math.h>

#include <cmath>
#include <cstddef>

/// Common code of the included methods. Meters, radians, seconds; robot frame: x forward, y left.
namespace reactive {

struct Point {
  double x = 0, y = 0;
};

struct Pose {
  double x = 0, y = 0, phi = 0;
};

/// Wraps an angle to (-pi, pi].
inline double wrapped(double angle) {
  const double turned = std::remainder(angle, 2 * M_PI);
  return turned <= -M_PI ? turned + 2 * M_PI : turned;
}

/// Direction of ray i of `count` in the robot's frame.
inline double ray_angle(std::size_t i, std::size_t count, double aperture) {
  return count < 2
             ? 0.0
             : -0.5 * aperture + aperture * static_cast<double>(i) / static_cast<double>(count - 1);
}

inline double distance(const Point& a, const Point& b) {
  return slalom::math::hypot(a.x - b.x, a.y - b.y);
}

/// Transforms points between the robot frame at a pose and the frame of that pose.
class Transform {
 public:
  explicit Transform(const Pose& pose) : Transform(pose, slalom::math::sin_cos(pose.phi)) {}

  Point to_world(const Point& p) const {
    return {x_ + cosine_ * p.x - sine_ * p.y, y_ + sine_ * p.x + cosine_ * p.y};
  }
  Point to_robot(const Point& p) const {
    const double dx = p.x - x_, dy = p.y - y_;
    return {cosine_ * dx + sine_ * dy, -sine_ * dx + cosine_ * dy};
  }

 private:
  Transform(const Pose& pose, const slalom::math::SinCos& heading)
      : x_(pose.x), y_(pose.y), cosine_(heading.cos), sine_(heading.sin) {}

  double x_, y_, cosine_, sine_;
};

/// Transforms a point from the robot frame to the frame of `pose`.
inline Point to_world(const Pose& pose, const Point& p) {
  return Transform(pose).to_world(p);
}

/// Transforms a point from the frame of `pose` to the robot frame.
inline Point to_robot(const Pose& pose, const Point& p) {
  return Transform(pose).to_robot(p);
}

}  // namespace reactive
