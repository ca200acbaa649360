// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/footprint.h"
#include "common/robot.h"

#include <optional>
#include <vector>

namespace reactive {

/// Effect of an arc on the heading: it depends on the angular velocity only.
struct Turn {
  double sinc = 1;              ///< length of the chord per length of the arc
  double cosine = 1, sine = 0;  ///< of the chord's direction
  double phi = 0;               ///< heading at the end, rad
};
/// The turn from heading `phi` during `time` s.
Turn turn_from(double phi, double w, double time);

/// The pose after `time` s at constant velocities, along an arc.
Pose integrate(const Pose& pose, const Twist& twist, double time);

/// Changes `from` towards `to`, within the acceleration limits for `time` s.
Twist apply_acceleration_limits(const Twist& from, const Twist& to, const Robot& robot,
                                double time);

/// For each twist the length (m) of its arc that the robot can move before its footprint comes
/// closer to an obstacle than `radius` allows (that of a disc around its center, or more than the
/// robot's for a margin), at most `limit`. Rotation in place counts as free: free_rotation().
std::vector<double> free_arc_lengths(const ClearanceMap& map, const Pose& pose,
                                     const std::vector<Twist>& twists, const Robot& robot,
                                     double radius, double limit);

/// The radius to keep clear: robot radius plus margin, or the current clearance if that is less, so
/// that a robot that is too close to an obstacle can still move.
double clearance_radius(const ClearanceMap& map, const Pose& pose, const Robot& robot,
                        double margin);

/// The command of a robot that is to stop, or to rotate in place, and cannot stop within `period`
/// s: it brakes on the arc that it moves on, which was checked for obstacles; others were not.
std::optional<Twist> brake_on_arc(const Twist& measured, const Robot& robot, double period);

/// Decides, with hysteresis, whether the robot must rotate in place towards a bearing, and to which
/// side.
class RotateInPlace {
 public:
  /// begin, end: bearings (rad) beyond which the rotation starts and within which it ends.
  explicit RotateInPlace(double begin, double end = 0.4) : begin_(begin), end_(end) {}

  void reset() { side_ = 0; }
  void take_over(const RotateInPlace& before) { side_ = before.side_; }
  bool update(double bearing);  ///< whether to rotate in place
  /// The same, and not if the footprint would touch an obstacle on its way to the bearing.
  bool update(double bearing, const ClearanceMap& map, const Pose& pose, const Robot& robot,
              double margin);
  /// The command; brake_on_arc() if the robot moves.
  Twist twist(double bearing, const Twist& measured, const Robot& robot, double period) const;

 private:
  double begin_, end_;
  int side_ = 0;  ///< +1 left, -1 right, 0 no rotation in place
};

}  // namespace reactive
