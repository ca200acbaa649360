#pragma once

#include "common/local_map.h"
#include "walls.h"

#include <vector>

namespace reactive {

using follow_the_gap::scan_of;
using follow_the_gap::Wall;
using follow_the_gap::wall_with_opening;

/// What a robot at the origin sees of walls, with the goal in its own frame.
inline Observation seen(const std::vector<Wall>& walls, const Point& goal,
                        const Speeds& measured = {}) {
  Observation observation;
  observation.goal = goal;
  observation.measured = measured;
  observation.ranges = scan_of(walls);
  return observation;
}

/// A map of what is seen from the origin.
inline LocalMap map_of(const std::vector<Wall>& walls) {
  LocalMap map({6, 0.05, 1.0}, {});
  map.update(seen(walls, {}));
  return map;
}

}  // namespace reactive
