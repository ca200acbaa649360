// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/local_map.h"
#include "walls.h"

#include <vector>

namespace reactive {

using follow_the_gap::scan_of;
using follow_the_gap::Wall;
using follow_the_gap::wall_with_opening;

/// The observation of walls from the origin, with the goal in the robot frame.
inline Observation observe(const std::vector<Wall>& walls, const Point& goal,
                           const Twist& measured = {}) {
  Observation observation;
  observation.goal = goal;
  observation.measured = measured;
  observation.ranges = scan_of(walls);
  return observation;
}

/// The local map after one observation from the origin.
inline LocalMap map_of(const std::vector<Wall>& walls) {
  LocalMap map({6, 1.0}, {});
  map.update(observe(walls, {}));
  return map;
}

}  // namespace reactive
