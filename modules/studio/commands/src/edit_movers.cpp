// SPDX-License-Identifier: BSD-3-Clause
#include "free_id.h"

#include <slalom/commands/edit_movers.h>
#include <slalom/core/distance.h>

#include <algorithm>
#include <utility>

namespace slalom {

using mrpt::math::TPoint2D;

double last_waypoint_time(const Movers& movers) {
  double last = 0;
  for (const Mover& mover : movers) last = std::max(last, mover.waypoints.back().t);
  return last;
}

std::optional<std::size_t> mover_at(const Scenario& scenario, const TPoint2D& point, double time) {
  const Movers& movers = scenario.movers();
  for (std::size_t i = movers.size(); i-- > 0;)
    if (movers[i].present(time) &&
        distance_between(movers[i].position(time), point) <= movers[i].radius)
      return i;
  return std::nullopt;
}

std::optional<WaypointIndex> waypoint_at(const Scenario& scenario, const TPoint2D& point,
                                         double tolerance) {
  std::optional<WaypointIndex> nearest;
  double smallest = tolerance;
  for (std::size_t i = 0; i < scenario.movers().size(); ++i)
    for (std::size_t k = 0; k < scenario.movers()[i].waypoints.size(); ++k) {
      const double distance = distance_between(scenario.movers()[i].waypoints[k].position, point);
      if (distance > smallest || (nearest && distance == smallest)) continue;
      nearest = WaypointIndex{i, k};
      smallest = distance;
    }
  return nearest;
}

Mover mover_along(const std::vector<TPoint2D>& path, double radius, double speed) {
  Mover mover;
  mover.radius = radius;
  for (const TPoint2D& point : path) mover.waypoints.push_back({0, point});
  if (path.size() > 1 && path.front() == path.back()) mover.after = MoverEnd::Loop;
  set_speed(mover, speed);
  return mover;
}

Mover moved(Mover mover, double dx, double dy) {
  for (Waypoint& waypoint : mover.waypoints) waypoint.position += TPoint2D(dx, dy);
  return mover;
}

Mover with_waypoint_moved(Mover mover, std::size_t waypoint, double dx, double dy) {
  const TPoint2D to = mover.waypoints.at(waypoint).position + TPoint2D(dx, dy);
  mover.waypoints[waypoint].position = to;
  const std::size_t last = mover.waypoints.size() - 1;
  if (mover.after == MoverEnd::Loop && (waypoint == 0 || waypoint == last))
    mover.waypoints[last - waypoint].position = to;
  return mover;
}

Scenario with_movers_edited(const Scenario& scenario, Movers movers) {
  return scenario.with_movers(std::move(movers)).with_published_path(nullptr);
}

Scenario with_mover_added(const Scenario& scenario, Mover mover) {
  Movers movers = scenario.movers();
  if (mover.id.empty()) mover.id = free_id(scenario, "mover_");
  movers.push_back(std::move(mover));
  return with_movers_edited(scenario, std::move(movers));
}

Scenario with_mover_replaced(const Scenario& scenario, std::size_t index, Mover mover) {
  Movers movers = scenario.movers();
  movers.at(index) = std::move(mover);
  return with_movers_edited(scenario, std::move(movers));
}

Scenario with_mover_removed(const Scenario& scenario, std::size_t index) {
  Movers movers = scenario.movers();
  movers.erase(movers.begin() + static_cast<std::ptrdiff_t>(index));
  return with_movers_edited(scenario, std::move(movers));
}

}  // namespace slalom
