#pragma once

#include <cmath>

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

inline double distance(const Point& a, const Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Transforms a point from the robot frame to the frame of `pose`.
inline Point to_world(const Pose& pose, const Point& p) {
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  return {pose.x + c * p.x - s * p.y, pose.y + s * p.x + c * p.y};
}

/// Transforms a point from the frame of `pose` to the robot frame.
inline Point to_robot(const Pose& pose, const Point& p) {
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  const double dx = p.x - pose.x, dy = p.y - pose.y;
  return {c * dx + s * dy, -s * dx + c * dy};
}

}  // namespace reactive
