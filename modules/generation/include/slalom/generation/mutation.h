// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/generation/coverage.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Mutations of a scenario. Random lengths are log-uniform between the cell size and a fraction of
/// the workspace.
enum class Mutation {
  Add,              ///< 1 to 32 discs or polygons at random positions
  Remove,           ///< a fraction of the obstacles
  Move,             ///< a fraction of the obstacles, by normally distributed offsets
  Resize,           ///< a fraction of the obstacles, each by its own factor
  ResizeAll,        ///< all obstacles by one factor
  Duplicate,        ///< a fraction of the obstacles, each copied with an offset
  Carve,            ///< removes obstacles near a random path from start to goal
  Fill,             ///< blocks on a lattice, except near a random path from start to goal
  Frame,            ///< occupied margins around a smaller area with start and goal
  ScaleWorkspace,   ///< workspace, obstacles, start and goal by one factor
  ExtendWorkspace,  ///< enlarges the workspace around the scene
  CropWorkspace,    ///< crops the workspace to a part with start and goal
  MoveStartGoal,    ///< changes start, goal or both
};
constexpr int kMutations = 13;

/// Limits on a mutated scenario.
struct MutationLimits {
  double robot_radius = 0.25, resolution = 0.05;  ///< m
  double min_extent = 4, max_extent = 40;         ///< m
  double min_distance = 2;                        ///< m, straight line from start to goal
  std::size_t max_obstacles = 5000;
};

/// The mutated scenario, or nullopt if the mutation does not apply (nothing to remove, a map whose
/// workspace cannot be scaled) or the result violates a limit. Obstacles in collision with the
/// robot at start or goal are removed. Grids change cell by cell; in point maps only start and goal
/// change. Movers remain as they are; a mutation that puts an obstacle, or the robot at the start,
/// in the way of one does not apply. So do people; a mutation after which problem_of_people() finds
/// one does not apply.
std::optional<Scenario> mutate(const Scenario& parent, Mutation mutation,
                               const MutationLimits& limits, RandomEngine& engine);

/// The scenario with another start, goal or speed of one of its people, with one more who resembles
/// another one, or with one less; nullopt if there are none, or problem_of_people() finds a problem
/// in the result.
std::optional<Scenario> mutate_people(const Scenario& parent, const MutationLimits& limits,
                                      RandomEngine& engine);

}  // namespace slalom
