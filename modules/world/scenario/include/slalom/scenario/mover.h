// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/enum_names.h>

#include <mrpt/math/TPoint2D.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

class Hasher;

/// Behavior of a moving obstacle after its last waypoint.
enum class MoverEnd { Stop, Loop, Vanish };
constexpr auto enum_names(MoverEnd) {
  return std::array{"stop", "loop", "vanish"};
}

/// A position (m, world frame) at a time (s of the run, which begins at 0).
struct Waypoint {
  double t = 0;
  mrpt::math::TPoint2D position;
};

/// s, the shortest segment between waypoints: the simulator moves from waypoint to waypoint.
constexpr double kMinSegmentDuration = 1e-3;

/// A moving obstacle: a closed disc that follows a given path, whatever the robot does. Between two
/// waypoints it moves straight at constant speed. It is present from its first waypoint on; one
/// that waits there first has two waypoints at the same position.
struct Mover {
  std::string id;
  double radius = 0;  ///< m
  std::vector<Waypoint> waypoints;
  /// Stop: it remains at the last waypoint. Loop: it repeats its path, which is closed, from the
  /// first waypoint on. Vanish: it is present up to the last waypoint, inclusive.
  MoverEnd after = MoverEnd::Stop;

  bool present(double t) const;
  /// Center (m) at time t (s), as if it were always present: before the first waypoint the position
  /// of that, after vanishing that of the last one.
  mrpt::math::TPoint2D position(double t) const;
  /// Velocity (m/s) from t on: at a waypoint that of the next segment; 0 while absent or at rest.
  mrpt::math::TPoint2D velocity(double t) const;
  /// The first time after t at which the velocity may change; infinity if there is none. Between
  /// the two the motion is straight at velocity(t), and the mover is either present or absent.
  double next_change(double t) const;

  bool operator==(const Mover& other) const;
  bool operator!=(const Mover& other) const { return !(*this == other); }

 private:
  struct Place;
  std::optional<Place> place_at(double t) const;
};

using Movers = std::vector<Mover>;

/// A part of a mover's motion: straight at a constant velocity, or at rest.
struct MoverSegment {
  double begin = 0, end = 0;            ///< s
  mrpt::math::TPoint2D from, velocity;  ///< m at `begin`, m/s
};

/// The motion of a mover from 0 to `horizon` (s) while it is present, in the order of time.
std::vector<MoverSegment> segments_of(const Mover& mover, double horizon);

/// Throws Error (File) naming `name` and the mover when an id is empty, too long (100 bytes), not
/// UTF-8 or used twice, a radius is not above 0, there are no waypoints, a number is not finite or
/// exceeds a million, a waypoint is less than 1 ms after the one before it, a speed exceeds 1000
/// m/s, or a path that loops is not closed (its last waypoint at the first).
void check_movers(const std::string& name, const Movers& movers);

/// The times of the waypoints that result from `speed` (m/s), from that of the first one on.
/// Segments last at least 2 ms.
void set_speed(Mover& mover, double speed);

void add_content(Hasher& hasher, const Movers& movers);

}  // namespace slalom
