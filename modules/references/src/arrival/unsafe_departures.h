// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "time_intervals.h"

#include <slalom/scenario/mover.h>

#include <optional>
#include <vector>

namespace slalom::arrival {

/// A straight motion of the robot's center, which takes `duration` (s, >= 0) whenever it departs.
struct Leg {
  mrpt::math::TPoint2D from, velocity;  ///< m, m/s
  double duration = 0;
};

/// The movers as the searches need them.
struct Traffic {
  std::vector<std::vector<MoverSegment>> segments;  ///< of each mover, in the order of time
  std::vector<double> distances;  ///< m, from each mover's center, below which is unsafe
};

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
