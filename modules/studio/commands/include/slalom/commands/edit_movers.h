// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// Edits of the movers of one scenario, like those of its static obstacles (edit_geometry.h). All
/// with_...() throw as check_movers() does; those with an index require one of a mover. Lengths in
/// m, world frame; times in s of a run.

/// The time of the last waypoint of all movers, at least 0.
double last_waypoint_time(const Movers& movers);

/// The last mover whose disc contains the point at `time`, while it is present; none otherwise.
std::optional<std::size_t> mover_at(const Scenario& scenario, const mrpt::math::TPoint2D& point,
                                    double time);

struct WaypointIndex {
  std::size_t mover = 0, waypoint = 0;
};
/// The nearest waypoint of all movers within `tolerance`; none otherwise.
std::optional<WaypointIndex> waypoint_at(const Scenario& scenario,
                                         const mrpt::math::TPoint2D& point, double tolerance);

/// A mover without an id along a path of one or more points, from time 0 on, at `speed` (m/s).
/// If the path ends where it began, the mover repeats it.
Mover mover_along(const std::vector<mrpt::math::TPoint2D>& path, double radius, double speed);
/// The mover, translated.
Mover moved(Mover mover, double dx, double dy);
/// The mover with one waypoint translated; with the other end of a path that is repeated.
Mover with_waypoint_moved(Mover mover, std::size_t waypoint, double dx, double dy);

/// Adds a mover; one without an id gets "mover_1" or the next number that is free.
Scenario with_mover_added(const Scenario& scenario, Mover mover);
Scenario with_mover_replaced(const Scenario& scenario, std::size_t index, Mover mover);
Scenario with_mover_removed(const Scenario& scenario, std::size_t index);
/// Replaces all movers.
Scenario with_movers_edited(const Scenario& scenario, Movers movers);

}  // namespace slalom
