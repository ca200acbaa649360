// SPDX-License-Identifier: BSD-3-Clause
#include "common/local_map.h"

namespace reactive {

LocalMap::LocalMap(const MapOptions& options, const Robot& robot)
    : robot_(robot),
      memory_(options.half_size, options.resolution),
      clearance_(options.half_size, options.resolution, options.band) {}

void LocalMap::update(const Observation& observation) {
  memory_.update(observation.pose, observation.ranges, robot_);
  clearance_.build({observation.pose.x, observation.pose.y}, memory_.points());
}

Waypoint LocalPlanner::find(const LocalMap& map, const Pose& pose, const Point& goal,
                            double look_ahead) {
  const Point position{pose.x, pose.y};
  const ClearanceMap& clearance = map.clearance();
  PathCosts costs = costs_;
  const double step = 0.5 * (costs_.clearance - min_clearance_);
  for (int i = 0; i < 3; ++i) {
    costs.clearance = costs_.clearance - i * step;
    cost_to_go_.compute(clearance, goal, position, costs);
    const auto path = cost_to_go_.path(position, look_ahead);
    if (path.empty()) continue;
    const Point visible = farthest_visible(clearance, position, path, costs.clearance);
    const bool at_goal = distance(visible, goal) < 2 * clearance.resolution();
    return {at_goal ? goal : visible, at_goal, true};
  }
  return {goal, false, false};
}

}  // namespace reactive
