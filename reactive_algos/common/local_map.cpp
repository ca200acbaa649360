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

Waypoint Guide::find(const LocalMap& map, const Pose& pose, const Point& goal, double look_ahead) {
  const Point here{pose.x, pose.y};
  const ClearanceMap& clearance = map.clearance();
  PathCosts costs = costs_;
  const double step = 0.5 * (costs_.clearance - least_clearance_);
  for (int narrower = 0; narrower < 3; ++narrower) {
    costs.clearance = costs_.clearance - narrower * step;
    cost_to_go_.compute(clearance, goal, here, costs);
    const auto path = cost_to_go_.path(here, look_ahead);
    if (path.empty()) continue;
    const Point seen = farthest_visible(clearance, here, path, costs.clearance);
    const bool arrives = distance(seen, goal) < 2 * clearance.resolution();
    return {arrives ? goal : seen, arrives, true};
  }
  return {goal, false, false};
}

}  // namespace reactive
