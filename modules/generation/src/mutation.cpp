#include "mutation.h"
#include "scene.h"

#include <cmath>

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
      return mutate_along_way(scene, mutation, limits, engine);
    case Mutation::Frame:
    case Mutation::ScaleFloor:
    case Mutation::ExtendFloor:
    case Mutation::CropFloor:
      return mutate_floor(scene, mutation, limits, engine);
    case Mutation::MoveTask:
      break;
  }
  move_task(scene.bounds, limits, engine, scene.start, scene.goal);
  return true;
}

/// Start and goal as another obstacle may now stand on them.
void clear_ends(Scene& scene, const MutationLimits& limits) {
  const double least = berth(limits);
  scene.drop_if([&](const Scene::Obstacle& obstacle) {
    return distance({scene.start.x, scene.start.y}, obstacle) < least ||
           distance(scene.goal, obstacle) < least;
  });
}

std::optional<Scenario> mutate_scene(const Scenario& parent, Mutation mutation,
                                     const MutationLimits& limits, RandomEngine& engine) {
  Scene scene(parent);
  if (!apply(scene, mutation, limits, engine)) return std::nullopt;
  clear_ends(scene, limits);
  if (scene.obstacles.size() > limits.max_obstacles) return std::nullopt;
  return scene.scenario(parent.name());
}

std::optional<Scenario> mutate_task(const Scenario& parent, const MutationLimits& limits,
                                    RandomEngine& engine) {
  mrpt::math::TPose2D start = parent.start();
  TPoint2D goal = parent.goal();
  move_task(parent.bounds(), limits, engine, start, goal);
  return parent.with_task(start, goal);
}

}  // namespace

std::optional<Scenario> mutate(const Scenario& parent, Mutation mutation,
                               const MutationLimits& limits, RandomEngine& engine) {
  std::optional<Scenario> child;
  if (parent.representation() == Representation::Continuous)
    child = mutate_scene(parent, mutation, limits, engine);
  else if (mutation == Mutation::MoveTask)
    child = mutate_task(parent, limits, engine);
  else if (parent.representation() == Representation::Grid)
    child = mutate_grid(parent, mutation, limits, engine);
  if (!child) return std::nullopt;
  const auto& start = child->start();
  const double straight = std::hypot(child->goal().x - start.x, child->goal().y - start.y);
  if (straight < limits.min_distance) return std::nullopt;
  return child;
}

}  // namespace slalom
