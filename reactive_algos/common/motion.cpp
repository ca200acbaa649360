#include "common/motion.h"

#include <algorithm>

namespace reactive {

Pose moved(const Pose& pose, const Speeds& speeds, double time) {
  const double turn = speeds.w * time;
  // The chord of an arc: its direction is the middle heading, its length that of the arc times
  // sin(a) / a of half the turn.
  const double half = 0.5 * turn;
  const double chord = speeds.v * time * (std::abs(half) < 1e-6 ? 1.0 : std::sin(half) / half);
  return {pose.x + chord * std::cos(pose.phi + half), pose.y + chord * std::sin(pose.phi + half),
          pose.phi + turn};
}

Speeds approached(const Speeds& from, const Speeds& to, const Robot& robot, double time) {
  const double dv = robot.max_accel_v * time, dw = robot.max_accel_w * time;
  return {std::clamp(to.v, from.v - dv, from.v + dv), std::clamp(to.w, from.w - dw, from.w + dw)};
}

double free_arc(const ClearanceMap& map, const Pose& pose, const Speeds& speeds, double radius,
                double limit) {
  if (speeds.v <= 0) return limit;
  constexpr double kLeastStep = 0.02;  // m
  double way = 0;
  while (way < limit) {
    // What is that far away cannot be touched sooner.
    const Pose at = moved(pose, speeds, way / speeds.v);
    const double room = map.at({at.x, at.y}) - radius;
    if (room < 0) return way;
    way += std::max(room, kLeastStep);
  }
  return limit;
}

double radius_to_keep(const ClearanceMap& map, const Pose& pose, const Robot& robot,
                      double margin) {
  constexpr double kLeast = 0.005;  // m beyond the radius
  const double here = map.at({pose.x, pose.y}) - kLeast;
  return std::clamp(here, robot.radius + kLeast, robot.radius + std::max(margin, kLeast));
}

bool TurnOnTheSpot::wanted(double bearing) {
  if (side_ == 0 && std::abs(bearing) > begin_) side_ = bearing > 0 ? 1 : -1;
  if (std::abs(bearing) < end_) side_ = 0;
  // Passing straight behind is no reason to turn back, passing straight ahead is.
  if (side_ * bearing < 0 && std::abs(bearing) < 0.5 * kPi) side_ = bearing > 0 ? 1 : -1;
  return side_ != 0;
}

Speeds TurnOnTheSpot::speeds(double bearing, const Robot& robot) const {
  const bool behind = side_ * bearing < 0;
  return {0, behind ? side_ * robot.max_w : turning_speed(bearing, robot)};
}

}  // namespace reactive
