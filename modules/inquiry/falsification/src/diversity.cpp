// SPDX-License-Identifier: BSD-3-Clause
#include "diversity.h"

#include <slalom/core/distance.h>
#include <slalom/core/geometry.h>
#include <slalom/core/math.h>
#include <slalom/core/pose.h>
#include <slalom/scenario/occupancy.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

bool sweeps(const Mover& mover, const TPoint2D& p) {
  TPoint2D from = mover.waypoints.front().position;
  return std::any_of(mover.waypoints.begin(), mover.waypoints.end(), [&](const Waypoint& next) {
    const TPoint2D nearest = nearest_on_segment(p, from, next.position);
    const bool is_near = distance_between(p, nearest) <= mover.radius;
    from = next.position;
    return is_near;
  });
}

/// The area that a person sweeps if nobody and nothing is in its way; times do not matter.
Mover straight_way(const Person& person) {
  Mover mover{person.id, person.radius, {}};
  for (const TPoint2D& point : stations_of(person)) mover.waypoints.push_back({0, point});
  return mover;
}

/// Whether a position (m, world frame) is in an obstacle; the border is none.
class ObstacleTest {
 public:
  ObstacleTest(const Scenario& scenario, double resolution)
      : movers_(scenario.movers()), occupancy_(make_occupancy(scenario, resolution)) {
    for (const Person& person : scenario.people()) movers_.push_back(straight_way(person));
  }
  bool operator()(const TPoint2D& p) const {
    const TPoint2D cell = occupancy_.to_cells(p);
    const int cx = static_cast<int>(std::floor(cell.x)), cy = static_cast<int>(std::floor(cell.y));
    if (!occupancy_.inside(cx, cy)) return false;
    return occupancy_.occupied(cx, cy) ||
           std::any_of(movers_.begin(), movers_.end(),
                       [&p](const Mover& mover) { return sweeps(mover, p); });
  }

 private:
  Movers movers_;
  Occupancy occupancy_;
};

/// The frame of the task in the world.
TPose2D task_frame(const Scenario& scenario) {
  const TPose2D& start = scenario.start();
  const TPoint2D& goal = scenario.goal();
  return {start.x, start.y, math::atan2(goal.y - start.y, goal.x - start.x)};
}

/// The square around the origin of the task's frame that contains the workspace: its half side, m.
double reach(const Scenario& scenario) {
  const Bounds& bounds = scenario.bounds();
  const TPose2D& start = scenario.start();
  return math::hypot(std::max(bounds.x_max - start.x, start.x - bounds.x_min),
                     std::max(bounds.y_max - start.y, start.y - bounds.y_min));
}

}  // namespace

ObstacleArea::ObstacleArea(const Scenario& scenario, double resolution) {
  const ObstacleTest is_obstacle(scenario, resolution);
  const TPose2D frame = task_frame(scenario);
  const int last = static_cast<int>(std::ceil(reach(scenario) / resolution));
  for (int x = -last; x < last; ++x)
    for (int y = -last; y < last; ++y)
      if (is_obstacle(compose(frame, {(x + 0.5) * resolution, (y + 0.5) * resolution})))
        cells_.emplace_back(x, y);
}

double ObstacleArea::dissimilarity(const ObstacleArea& other) const {
  std::vector<std::pair<int, int>> common;
  std::set_intersection(cells_.begin(), cells_.end(), other.cells_.begin(), other.cells_.end(),
                        std::back_inserter(common));
  const std::size_t united = cells_.size() + other.cells_.size() - common.size();
  return united == 0 ? 0 : 1 - static_cast<double>(common.size()) / static_cast<double>(united);
}

bool is_distinct(const ObstacleArea& area, const std::vector<ObstacleArea>& others) {
  return std::all_of(others.begin(), others.end(), [&area](const ObstacleArea& other) {
    return area.dissimilarity(other) >= kMinDissimilarity;
  });
}

std::optional<double> diversity(const std::vector<ObstacleArea>& areas) {
  if (areas.size() < 2) return std::nullopt;
  double sum = 0;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < areas.size(); ++i)
    for (std::size_t j = 0; j < i; ++j, ++pairs) sum += areas[i].dissimilarity(areas[j]);
  return sum / static_cast<double>(pairs);
}

}  // namespace slalom
