// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/costmap.h"
#include "common/robot.h"
#include "dwa_local_planner/parameters.h"

#include <cmath>
#include <vector>

namespace dwa_local_planner {

constexpr reactive::Inflation kInflation = {0.165, 0.3, 10};

/// The Jackal of BARN: 0.42 m x 0.33 m.
inline reactive::Robot jackal() {
  reactive::Robot robot;
  robot.footprint = {{0.21, 0.165}, {-0.21, 0.165}, {-0.21, -0.165}, {0.21, -0.165}};
  robot.radius = std::hypot(0.21, 0.165);
  robot.max_v = 0.5;
  robot.max_w = 1.57;
  return robot;
}

/// Parameters with limits, as a method has them.
inline Parameters limited_parameters() {
  Parameters parameters;
  parameters.max_vel_x = 0.5;
  parameters.max_vel_theta = 1.57;
  parameters.acc_lim_x = 1;
  parameters.acc_lim_theta = 3;
  return parameters;
}

inline reactive::Costmap costmap_of(const std::vector<reactive::Point>& points) {
  reactive::Costmap map(3, 0.05, kInflation, 0.7);
  map.build({0, 0}, points);
  return map;
}

}  // namespace dwa_local_planner
