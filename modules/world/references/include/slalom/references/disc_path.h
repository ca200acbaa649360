// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/occupancy.h>
#include <slalom/trajectory/path.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A part of a shortest path around the corner of an occupied cell, at the robot's radius from it.
struct DiscArc {
  mrpt::math::TPoint2D center;  ///< the corner, m
  int turn = 0;                 ///< +1 left (counterclockwise), -1 right
  double first_angle = 0;       ///< of its first point as seen from the center, rad
  double sweep = 0;             ///< angle turned, rad, >= 0
};

/// The shortest path of a disc: arcs, connected by straight segments tangent to them.
struct DiscPath {
  mrpt::math::TPoint2D start, goal;
  double radius = 0;          ///< of the arcs, m
  double length = 0;          ///< m, of the segments and arcs
  std::vector<DiscArc> arcs;  ///< from start to goal; empty if the path is straight
};

/// The exact shortest path of the center of a disc (robot_radius, start and goal in m) among the
/// closed occupied squares of `cells`, in the model of collision checking: it may be closer to them
/// than the radius by kContactTolerance, so that passages of exactly twice the radius are open. The
/// length is the optimum to rounding errors. nullopt with `reason` if start or goal is not free, or
/// if there is no path, which is then proved.
///
/// Method: best-first any-angle search (Harabor et al. 2016, "Optimal any-angle pathfinding in
/// practice") whose roots are the arcs about convex corners instead of points.
std::optional<DiscPath> shortest_disc_path(const Occupancy& cells, double robot_radius,
                                           const mrpt::math::TPoint2D& start,
                                           const mrpt::math::TPoint2D& goal, std::string& reason);

/// A polyline around the arcs of a path found on `cells`, free for the disc: it is longer than the
/// path, by at most the fraction `max_excess` of its length.
Path to_polyline(const DiscPath& path, const Occupancy& cells, double max_excess = 1e-6);

}  // namespace slalom
