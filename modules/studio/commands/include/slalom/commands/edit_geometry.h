// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// Edits of one scenario. Each returns a new scenario of the same name, which replaces the old one
/// with make_edit_scenario(). A published path is dropped, since it belongs to the old content. All
/// throw Error (Usage) for invalid edits: a point outside the bounds, start or goal on an obstacle,
/// an obstacle that does not touch the workspace, the wrong representation. Lengths in m, world
/// frame.

Scenario with_start(const Scenario& scenario, const mrpt::math::TPose2D& start);
Scenario with_goal(const Scenario& scenario, const mrpt::math::TPoint2D& goal);

/// Obstacles are indexed from 0: discs first, then polygons. The last one is drawn on top.
std::size_t obstacle_count(const Primitives& obstacles);
/// The topmost obstacle that contains the point, else the nearest within `tolerance`, else none.
/// Always none for scenarios without primitives.
std::optional<std::size_t> obstacle_at(const Scenario& scenario, const mrpt::math::TPoint2D& point,
                                       double tolerance);
Scenario with_obstacle_added(const Scenario& scenario, const Disc& disc);
Scenario with_obstacle_added(const Scenario& scenario, const Polygon& polygon);
Scenario with_obstacle_moved(const Scenario& scenario, std::size_t index, double dx, double dy);
Scenario with_obstacle_removed(const Scenario& scenario, std::size_t index);

/// A brush stroke along a polyline.
struct Stroke {
  std::vector<mrpt::math::TPoint2D> points;  ///< one or more
  double radius = 0;                         ///< of the brush, m
};

/// Sets the cells whose center is under the brush, and those that contain a point of the stroke, to
/// occupied or free. Parts of the stroke outside the grid have no effect.
Scenario with_cells_painted(const Scenario& scenario, const Stroke& stroke, bool occupied);

Scenario with_points_added(const Scenario& scenario,
                           const std::vector<mrpt::math::TPoint2D>& points);
/// Removes the points under the brush.
Scenario with_points_removed(const Scenario& scenario, const Stroke& stroke);

}  // namespace slalom
