#pragma once

#include <slalom/core/random.h>
#include <slalom/generation/coverage.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The ways in which a scenario is changed a little, or a lot. Lengths that are drawn lie between
/// the cell size and a share of the floor, evenly in their logarithm.
enum class Mutation {
  Add,          ///< 1 to 32 discs or polygons at random places
  Remove,       ///< a share of the obstacles
  Move,         ///< a share of the obstacles, by a normal distribution
  Resize,       ///< a share of the obstacles, each by a factor of its own
  ResizeAll,    ///< all obstacles by one factor
  Duplicate,    ///< a share of the obstacles, each beside itself
  Carve,        ///< what is near a way from start to goal is taken away
  Fill,         ///< blocks on a lattice wherever they leave a way from start to goal free
  Frame,        ///< rock around a smaller room that still holds start and goal
  ScaleFloor,   ///< floor, obstacles and task, by one factor
  ExtendFloor,  ///< the floor grows around the scene
  CropFloor,    ///< the floor is cut down to a part that holds start and goal
  MoveTask,     ///< another start or goal, or both
};
constexpr int kMutations = 13;

/// What a changed scenario must keep to.
struct MutationLimits {
  double robot_radius = 0.25, resolution = 0.05;  ///< m
  double min_floor = 4, max_floor = 40;           ///< m
  double min_distance = 2;                        ///< m, straight from start to goal
  std::size_t max_obstacles = 5000;
};

/// The scenario changed, or nullopt where the mutation does not apply to it (nothing to remove, a
/// map whose floor cannot be stretched) or its result breaks a limit. Obstacles within the robot's
/// reach of start and goal are taken away. Grids change cell by cell; of point maps only the task.
std::optional<Scenario> mutate(const Scenario& parent, Mutation mutation,
                               const MutationLimits& limits, RandomEngine& engine);

}  // namespace slalom
