// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "families/walls.h"

#include <slalom/generation/mutation.h>
#include <slalom/generation/scene.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace slalom {

inline double shorter_side(const Scene& scene) {
  return std::min(scene.bounds.width(), scene.bounds.height());
}
/// Clearance (m) kept around start, goal and paths.
inline double clearance_margin(const MutationLimits& limits) {
  return limits.robot_radius + 1.5 * limits.resolution;
}

/// A random polyline from start to goal with up to two intermediate points within the bounds.
std::vector<mrpt::math::TPoint2D> sample_path(const Bounds& bounds,
                                              const mrpt::math::TPose2D& start,
                                              const mrpt::math::TPoint2D& goal,
                                              RandomEngine& engine);

/// Distance from a point to a path.
double distance(const mrpt::math::TPoint2D& p, const std::vector<mrpt::math::TPoint2D>& path);

/// Log-uniform in [low, max(low, high)].
double sample_log_uniform(RandomEngine& engine, double low, double high);

/// Moves start, goal or both to random positions within the bounds.
void move_start_goal(const Bounds& bounds, const MutationLimits& limits, RandomEngine& engine,
                     mrpt::math::TPose2D& start, mrpt::math::TPoint2D& goal);

/// In-place mutations of a continuous scene, by what they change; false if one does not apply.
bool mutate_obstacles(Scene& scene, Mutation mutation, const MutationLimits& limits,
                      RandomEngine& engine);
bool mutate_along_path(Scene& scene, Mutation mutation, const MutationLimits& limits,
                       RandomEngine& engine);  ///< from start to goal
bool mutate_workspace(Scene& scene, Mutation mutation, const MutationLimits& limits,
                      RandomEngine& engine);

/// Mutations of grids, cell by cell; nullopt if the mutation does not apply.
std::optional<Scenario> mutate_grid(const Scenario& parent, Mutation mutation,
                                    const MutationLimits& limits, RandomEngine& engine);

}  // namespace slalom
