// SPDX-License-Identifier: BSD-3-Clause
#include "scene_mutation.h"

#include <slalom/core/distance.h>
#include <slalom/scenario/world.h>

#include <algorithm>

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

/// Whether a mover touches an obstacle or the border on its path, or the robot when the run begins.
bool collides(const Mover& mover, const World& world, double robot_radius) {
  const auto& start = world.scenario().start();
  const auto& waypoints = mover.waypoints;
  if (mover.present(0) && distance_between(mover.position(0), start) < mover.radius + robot_radius)
    return true;
  const auto is_blocked = [&](const Waypoint& a, const Waypoint& b) {
    return world.distance_field().segment_clearance(a.position, b.position, mover.radius) <
           mover.radius;
  };
  if (is_blocked(waypoints[0], waypoints[0])) return true;
  for (std::size_t i = 1; i < waypoints.size(); ++i)
    if (is_blocked(waypoints[i - 1], waypoints[i])) return true;
  return false;
}

/// Whether each mover of the child is as free as it was: its path is that of the parent.
bool keeps_movers_free(const Scenario& parent, const Scenario& child,
                       const MutationLimits& limits) {
  if (child.movers().empty()) return true;
  const World before(parent, limits.resolution), after(child, limits.resolution);
  const auto is_new_collision = [&](const Mover& mover) {
    return collides(mover, after, limits.robot_radius) &&
           !collides(mover, before, limits.robot_radius);
  };
  return std::none_of(child.movers().begin(), child.movers().end(), is_new_collision);
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
  if (!keeps_movers_free(parent, *child, limits)) return std::nullopt;
  return child;
}

}  // namespace slalom
