// SPDX-License-Identifier: BSD-3-Clause
#include "cones.h"
#include "connection.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/references/disc_path.h>
#include <slalom/scenario/contact.h>

namespace slalom {
namespace disc_path {
namespace {

/// The radius (cells) of the disc that the collision check tests. Not 0 for a point: it does not
/// pass between cells that touch at a corner.
double planned_radius(double robot_radius, double resolution) {
  constexpr double kMinRadius = 1e-6;
  return std::max((robot_radius - kContactTolerance) / resolution, kMinRadius);
}

/// The path by way of the last root to the goal, in m.
DiscPath path_through(const Roots& roots, int last, const Occupancy& cells) {
  DiscPath path;
  Vector departure = roots.best_departure();
  for (int i = last; roots[i].turn != 0; i = roots[i].parent) {
    const Root& root = roots[i];
    const Vector leaving = (departure - root.center) * (1 / root.radius);
    path.arcs.push_back({cells.to_world(root.center.x, root.center.y), root.turn,
                         math::atan2(root.arrival.y, root.arrival.x),
                         turned_angle(root.arrival, leaving, root.turn)});
    departure = root.left_parent_at;
  }
  std::reverse(path.arcs.begin(), path.arcs.end());
  return path;
}

/// Taken from the queue before open cells are filled: most searches have ended by then, and the
/// others take longer than to fill.
constexpr int kItemsBeforeFill = 1000;

/// The shortest path if there is one, with its length in cells.
std::optional<DiscPath> search(SearchSpace& space, const Occupancy& cells) {
  Queue queue;
  Roots roots(space, queue);
  ConeExpansion cones(space, roots, queue);
  roots.offer_goal(0);
  if (queue.empty()) cones.expand_start();
  for (int taken = 0; !queue.empty(); ++taken) {
    if (taken == kItemsBeforeFill && !may_connect(space.open, space.start, space.goal))
      return std::nullopt;
    const Queue::Item item = queue.pop();
    if (item.kind == Kind::Goal) {
      DiscPath path = path_through(roots, item.index, cells);
      path.length = item.f;
      return path;
    }
    if (item.kind == Kind::Cone)
      cones.expand(queue.cone(item));
    else if (!roots[item.index].is_beaten)
      cones.expand_arc(item.index);
  }
  return std::nullopt;
}

}  // namespace
}  // namespace disc_path

std::optional<DiscPath> shortest_disc_path(const Occupancy& cells, double robot_radius,
                                           const mrpt::math::TPoint2D& start,
                                           const mrpt::math::TPoint2D& goal, std::string& reason) {
  const double resolution = cells.resolution();
  disc_path::SearchSpace space(cells, disc_path::planned_radius(robot_radius, resolution),
                               cells.to_cells(start), cells.to_cells(goal));
  for (const auto& [p, name] : {std::pair(space.start, "start"), std::pair(space.goal, "goal")})
    if (!space.is_sweep_free(p, p)) {
      reason = std::string(name) + " is closer to an obstacle than the robot's radius";
      return std::nullopt;
    }
  std::optional<DiscPath> path = disc_path::search(space, cells);
  if (!path) {
    reason = "no path from start to goal is wide enough for the robot";
    return std::nullopt;
  }
  path->start = start;
  path->goal = goal;
  path->radius = space.radius * resolution;
  // A straight path has no errors of cells.
  path->length = path->arcs.empty() ? distance_between(start, goal) : path->length * resolution;
  return path;
}

}  // namespace slalom
