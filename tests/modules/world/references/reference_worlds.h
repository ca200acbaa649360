// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/references/reference.h>

namespace slalom {

/// Footprints: a rectangle, one with the center near its rear, one with a recess.
constexpr char kRectangle[] = "0.42,0.21; -0.42,0.21; -0.42,-0.21; 0.42,-0.21";
constexpr char kRearAxle[] = "0.69,0.29; -0.2,0.29; -0.2,-0.29; 0.69,-0.29";
constexpr char kCorner[] = "0.5,0.25; -0.3,0.25; -0.3,-0.35; -0.05,-0.35; -0.05,-0.1; 0.5,-0.1";

inline PlanningProblem problem_of(const World& world, double radius) {
  const auto& start = world.scenario().start();
  return {world, radius, {start.x, start.y}, world.scenario().goal()};
}

/// An empty square of `size` meters.
inline World empty_world(double size, const mrpt::math::TPoint2D& start,
                         const mrpt::math::TPoint2D& goal) {
  return {Scenario::continuous("empty", {0, 0, size, size}, {}, {start.x, start.y, 0}, goal), 0.05};
}

/// A square divided by a wall with an opening of about `gap` meters (less up to two cells of
/// rasterization).
inline World walled_world(double size, double gap) {
  const double middle = size / 2;
  Primitives walls;
  walls.polygons.push_back({{{middle - 0.1, 0},
                             {middle + 0.1, 0},
                             {middle + 0.1, middle - gap / 2},
                             {middle - 0.1, middle - gap / 2}}});
  walls.polygons.push_back({{{middle - 0.1, middle + gap / 2},
                             {middle + 0.1, middle + gap / 2},
                             {middle + 0.1, size},
                             {middle - 0.1, size}}});
  return {Scenario::continuous("walled", {0, 0, size, size}, walls, {1, 2, 0}, {size - 1, 2}),
          0.05};
}

/// A square of `size` meters with random discs; start and goal in opposite corners.
inline World random_world(RandomEngine& engine, double size, int discs) {
  Primitives obstacles;
  for (int i = 0; i < discs; ++i)
    obstacles.discs.push_back({{uniform_real(engine, 0, size), uniform_real(engine, 0, size)},
                               uniform_real(engine, 0.1, 0.5)});
  return {Scenario::continuous("random", {0, 0, size, size}, obstacles, {0.5, 0.5, 0},
                               {size - 0.5, size - 0.5}),
          0.05};
}

}  // namespace slalom
