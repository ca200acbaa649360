#pragma once

#include <slalom/scenario/scenario.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// Edits of one scenario: each gives a new scenario with a new content and the same name, to be put
/// in the old one's place by make_edit_scenario(). A published path is dropped: it belongs to the
/// old content. All throw Error (Usage) telling what is impossible and what was expected: a place
/// outside the bounds, start or goal on an obstacle, an obstacle that no longer touches the
/// workspace, an edit of another representation. Lengths in m, world frame.

Scenario with_start(const Scenario& scenario, const mrpt::math::TPose2D& start);
Scenario with_goal(const Scenario& scenario, const mrpt::math::TPoint2D& goal);

/// Primitives are numbered: discs from 0, polygons after them. The last one is drawn on top.
std::size_t obstacle_count(const Primitives& obstacles);
/// The topmost obstacle in which the point lies; else the nearest no further away than `tolerance`;
/// else none. None in scenarios that are not made of primitives.
std::optional<std::size_t> obstacle_at(const Scenario& scenario, const mrpt::math::TPoint2D& point,
                                       double tolerance);
Scenario with_obstacle_added(const Scenario& scenario, const Disc& disc);
Scenario with_obstacle_added(const Scenario& scenario, const Polygon& polygon);
Scenario with_obstacle_moved(const Scenario& scenario, std::size_t index, double dx, double dy);
Scenario with_obstacle_removed(const Scenario& scenario, std::size_t index);

/// A brush drawn along a line from point to point.
struct Stroke {
  std::vector<mrpt::math::TPoint2D> points;  ///< one or more
  double radius = 0;                         ///< of the brush
};

/// Cells whose centre is under the brush, and those in which a point of the stroke lies, become
/// occupied or free. What of the stroke lies outside the grid has no effect.
Scenario with_cells_painted(const Scenario& scenario, const Stroke& stroke, bool occupied);

Scenario with_points_added(const Scenario& scenario,
                           const std::vector<mrpt::math::TPoint2D>& points);
/// Without the points under the brush.
Scenario with_points_removed(const Scenario& scenario, const Stroke& stroke);

}  // namespace slalom
