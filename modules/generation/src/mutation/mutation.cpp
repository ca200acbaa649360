#include "scene_mutation.h"

#include <slalom/core/distance.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// False where the mutation does not apply.
bool apply(Scene& scene, Mutation mutation, const MutationLimits& limits, RandomEngine& engine) {
  switch (mutation) {
    case Mutation::Add:
    case Mutation::Remove:
    case Mutation::Move:
    case Mutation::Resize:
    case Mutation::ResizeAll:
    case Mutation::Duplicate:
      return mutate_obstacles(scene, mutation, limits, engine);
    case Mutation::Carve:
    case Mutation::Fill:
      return mutate_along_path(scene, mutation, limits, engine);
    case Mutation::Frame:
    case Mutation::ScaleWorkspace:
    case Mutation::ExtendWorkspace:
    case Mutation::CropWorkspace:
      return mutate_workspace(scene, mutation, limits, engine);
    case Mutation::MoveStartGoal:
      break;
  }
  move_start_goal(scene.bounds, limits, engine, scene.start, scene.goal);
  return true;
}

/// Removes obstacles that overlap the robot at start or goal.
void clear_start_goal(Scene& scene, const MutationLimits& limits) {
  const double margin = clearance_margin(limits);
  scene.remove_if([&](const Scene::Obstacle& obstacle) {
    return distance({scene.start.x, scene.start.y}, obstacle) < margin ||
           distance(scene.goal, obstacle) < margin;
  });
}

std::optional<Scenario> mutate_scene(const Scenario& parent, Mutation mutation,
                                     const MutationLimits& limits, RandomEngine& engine) {
  Scene scene(parent);
  if (!apply(scene, mutation, limits, engine)) return std::nullopt;
  clear_start_goal(scene, limits);
  if (scene.obstacles.size() > limits.max_obstacles) return std::nullopt;
  return scene.scenario(parent.name());
}

std::optional<Scenario> mutate_start_goal(const Scenario& parent, const MutationLimits& limits,
                                          RandomEngine& engine) {
  mrpt::math::TPose2D start = parent.start();
  TPoint2D goal = parent.goal();
  move_start_goal(parent.bounds(), limits, engine, start, goal);
  return parent.with_start_goal(start, goal);
}

}  // namespace

std::optional<Scenario> mutate(const Scenario& parent, Mutation mutation,
                               const MutationLimits& limits, RandomEngine& engine) {
  std::optional<Scenario> child;
  if (parent.representation() == Representation::Continuous)
    child = mutate_scene(parent, mutation, limits, engine);
  else if (mutation == Mutation::MoveStartGoal)
    child = mutate_start_goal(parent, limits, engine);
  else if (parent.representation() == Representation::Grid)
    child = mutate_grid(parent, mutation, limits, engine);
  if (!child) return std::nullopt;
  const auto& start = child->start();
  const double straight = distance_between(child->goal(), start);
  if (straight < limits.min_distance) return std::nullopt;
  return child;
}

}  // namespace slalom
