// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/references/reference.h>

namespace slalom {

constexpr double kRadius = 0.25;  // m

/// Four discs between the corners of a room of 8 m.
inline World disc_world() {
  Primitives obstacles;
  obstacles.discs = {{{2.5, 2.2}, 0.6}, {{4.2, 4.4}, 0.8}, {{5.8, 3.4}, 0.5}, {{3.0, 5.8}, 0.5}};
  return {Scenario::continuous("discs", {0, 0, 8, 8}, obstacles, {0.6, 0.6, 0}, {7.4, 7.4}), 0.05};
}

/// A wall from side to side between start and goal.
inline World divided_world() {
  Primitives wall;
  wall.polygons.push_back({{{0, 3.8}, {8, 3.8}, {8, 4.2}, {0, 4.2}}});
  return {Scenario::continuous("parted", {0, 0, 8, 8}, wall, {1, 1, 0}, {7, 7}), 0.05};
}

/// For a disc, from the scenario's start to its goal.
inline PlanningProblem problem_of(const World& world) {
  const auto& start = world.scenario().start();
  return {world, kRadius, {start.x, start.y}, world.scenario().goal(), start.phi};
}

}  // namespace slalom
