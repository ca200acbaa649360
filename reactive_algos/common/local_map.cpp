// SPDX-License-Identifier: BSD-3-Clause
#include "common/local_map.h"

#include <algorithm>
#include <cmath>

namespace reactive {

LocalMap::LocalMap(const MapOptions& options, const Robot& robot)
    : robot_(robot),
      band_(options.band),
      memory_(options.half_size, options.resolution),
      clearance_(options.half_size, options.resolution, options.band) {}

void LocalMap::update(const Observation& observation) {
  memory_.update(observation.pose, observation.ranges, robot_);
  const Point robot{observation.pose.x, observation.pose.y};
  const Point goal = to_world(observation.pose, observation.goal);
  Point low{std::min(robot.x, goal.x), std::min(robot.y, goal.y)};
  Point high{std::max(robot.x, goal.x), std::max(robot.y, goal.y)};
  for (const Point& p : memory_.points()) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  // Paths lead around all that is seen. In steps, so that the square seldom changes.
  constexpr double kAround = 1, kStep = 1;  // m
  const double border = band_ + kAround;
  low = {kStep * std::floor((low.x - border) / kStep),
         kStep * std::floor((low.y - border) / kStep)};
  const double extent = std::max(high.x - low.x, high.y - low.y) + border;
  const double side = 2 * kStep * std::ceil(extent / (2 * kStep));
  if (side < 2 * memory_.half_size())
    clearance_.build(low, side, memory_.points());
  else
    clearance_.build(robot, memory_.points());
}

Waypoint LocalPlanner::find(const LocalMap& map, const Pose& pose, const Point& goal,
                            double look_ahead) {
  const Point position{pose.x, pose.y};
  const ClearanceMap& clearance = map.clearance();
  PathCosts costs = costs_;
  // A robot that is closer to an obstacle than paths lead would see nothing of its path.
  constexpr double kTolerance = 0.005;  // m
  const double own_clearance = clearance.at(position) - kTolerance;
  const double step = 0.5 * (costs_.clearance - min_clearance_);
  for (int i = 0; i < 3; ++i) {
    costs.clearance = costs_.clearance - i * step;
    cost_to_go_.compute(clearance, goal, position, costs);
    const auto path = cost_to_go_.path(position, look_ahead);
    if (path.empty()) continue;
    const Point visible =
        farthest_visible(clearance, position, path, std::min(costs.clearance, own_clearance));
    const bool at_goal = distance(visible, goal) < 2 * clearance.resolution();
    return {at_goal ? goal : visible, at_goal, true};
  }
  return {goal, false, false};
}

}  // namespace reactive
