// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "time_intervals.h"

#include <slalom/scenario/geometry.h>
#include <slalom/scenario/mover.h>

#include <optional>
#include <vector>

namespace slalom::arrival {

/// A straight motion of the robot's center, which takes `duration` (s, >= 0) whenever it departs.
struct Leg {
  mrpt::math::TPoint2D from, velocity;  ///< m, m/s
  double duration = 0;
};

/// A mover as the searches need it.
class MoverMotion {
 public:
  /// `segments` in the order of time; nearer to the mover's center than `distance` (m) is unsafe.
  MoverMotion(std::vector<MoverSegment> segments, double distance);

  /// Adds the unsafe departures; of those outside of `window` some may be missing.
  void add_unsafe_departures(const Leg& leg, const Interval& window,
                             std::vector<Interval>& unsafe) const;

 private:
  std::vector<MoverSegment> segments_;
  std::vector<Bounds> boxes_;  ///< m, of the center, in each run of kSegmentsPerBox segments
  double distance_;
};

using Traffic = std::vector<MoverMotion>;

/// All movers, from whose edges the robot's center must keep `distance` (m).
Traffic traffic_of(const Movers& movers, double distance, double horizon);

/// The times of departure at which the robot comes closer than `distance` (m) to the center of the
/// mover during the segment: an open interval, since the pairs of departure and time since then at
/// which it is closer are a convex set. nullopt if there are none.
std::optional<Interval> unsafe_departures(const Leg& leg, const MoverSegment& segment,
                                          double distance);

/// Unsafe departures for all movers; of those outside of `window` some may be missing.
std::vector<Interval> unsafe_departures(const Leg& leg, const Traffic& traffic,
                                        const Interval& window);

/// The maximal intervals within [0, horizon] in which a robot can stand at p, in order.
std::vector<Interval> safe_intervals(const mrpt::math::TPoint2D& p, const Traffic& traffic,
                                     double horizon);

}  // namespace slalom::arrival
