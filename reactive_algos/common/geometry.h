#pragma once

#include <cmath>

/// What the shipped methods share. Metres, radians, seconds; robot frame: x ahead, y left.
namespace reactive {

constexpr double kPi = 3.14159265358979323846;

struct Point {
  double x = 0, y = 0;
};

struct Pose {
  double x = 0, y = 0, phi = 0;
};

/// An angle brought into (-pi, pi].
inline double wrapped(double angle) {
  const double turned = std::remainder(angle, 2 * kPi);
  return turned <= -kPi ? turned + 2 * kPi : turned;
}

inline double distance(const Point& a, const Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// A point of the robot's frame in the frame of `pose`.
inline Point to_world(const Pose& pose, const Point& p) {
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  return {pose.x + c * p.x - s * p.y, pose.y + s * p.x + c * p.y};
}

/// A point of the frame of `pose` in the robot's frame.
inline Point to_robot(const Pose& pose, const Point& p) {
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  const double dx = p.x - pose.x, dy = p.y - pose.y;
  return {c * dx + s * dy, -s * dx + c * dy};
}

}  // namespace reactive
