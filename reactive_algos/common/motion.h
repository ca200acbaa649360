#pragma once

#include "common/clearance_map.h"
#include "common/robot.h"

namespace reactive {

/// The pose after driving with constant speeds for `time` s, along an arc.
Pose moved(const Pose& pose, const Speeds& speeds, double time);

/// `from` changed towards `to` as far as the robot's accelerations allow within `time` s.
Speeds approached(const Speeds& from, const Speeds& to, const Robot& robot, double time);

/// Length (m) of the arc of `speeds` that a disc of `radius` can drive before it touches something,
/// at most `limit`. Turning on the spot touches nothing.
double free_arc(const ClearanceMap& map, const Pose& pose, const Speeds& speeds, double radius,
                double limit);

/// The radius to keep clear: radius and margin, or what room there is now if that is less: a robot
/// that came too near must be able to drive on.
double radius_to_keep(const ClearanceMap& map, const Pose& pose, const Robot& robot, double margin);

/// Decides when the way lies so far aside that the robot turns without driving, and to which side;
/// does not change its mind half way.
class TurnOnTheSpot {
 public:
  /// begin, end: rad; turning begins beyond `begin` and ends within `end`.
  TurnOnTheSpot(double begin, double end) : begin_(begin), end_(end) {}

  void reset() { side_ = 0; }
  bool wanted(double bearing);
  Speeds speeds(double bearing, const Robot& robot) const;

 private:
  double begin_, end_;
  int side_ = 0;  ///< +1 left, -1 right, 0: driving
};

}  // namespace reactive
