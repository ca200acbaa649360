// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/robot/footprint.h>
#include <slalom/scenario/mover.h>

#include <mrpt/math/TPose2D.h>

namespace slalom {

/// A motion of the robot: position and heading are interpolated linearly over the time.
struct TimedMotion {
  mrpt::math::TPose2D from, to;
  double begin = 0, end = 0;  ///< s of the run
};

/// Collision checking of a footprint with moving obstacles: of a disc in closed form, of a polygon
/// by conservative advancement. Touching without overlap is free, as for static obstacles.
class MoverContact {
 public:
  /// `movers` must outlive this. They may get more waypoints, with speeds up to `added_speed`
  /// (m/s), before the motion that is checked comes to the last one.
  MoverContact(const Movers& movers, const Footprint& footprint, double added_speed = 0);

  /// A mover that overlaps the robot at time t; null if there is none.
  const Mover* find_overlap(const mrpt::math::TPose2D& pose, double t) const;

  /// The mover that touches the robot first on this motion, null if none does; then `fraction`
  /// (0..1) is the position along the motion at which it does.
  /// Consecutive calls must be contiguous: `from` and `begin` are the last `to` and `end`.
  const Mover* find_contact(const TimedMotion& motion, double& fraction);

 private:
  double gap(const mrpt::math::TPose2D& pose, const Mover& mover, double t) const;
  bool find_contact(const TimedMotion& motion, const Mover& mover, double& fraction) const;
  bool find_straight_contact(const TimedMotion& motion, const Mover& mover, double& fraction) const;
  double disc_contact(const TimedMotion& motion, const Mover& mover) const;
  double polygon_contact(const TimedMotion& motion, const Mover& mover) const;
  double smallest_gap(const TimedMotion& motion) const;

  const Movers& movers_;
  Footprint footprint_;
  double max_speed_;  ///< m/s, of all movers
  /// Distance (m) by which robot and movers together can move without contact.
  double free_travel_ = 0;
};

}  // namespace slalom
