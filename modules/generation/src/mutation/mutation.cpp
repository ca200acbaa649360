// SPDX-License-Identifier: BSD-3-Clause
#include "scene_mutation.h"

#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/generation/sample_people.h>
#include <slalom/generation/start_goal.h>
#include <slalom/scenario/world.h>

#include <algorithm>
#include <string>

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

/// Changes one of some people.
class PeopleMutator {
 public:
  PeopleMutator(const Bounds& bounds, const MutationLimits& limits, RandomEngine& engine)
      : bounds_(bounds), limits_(limits), engine_(engine) {}

  /// Requires at least one.
  void apply(People& people) {
    const std::size_t i = any_of(people.size());
    switch (any_of(5)) {
      case 0:
        return move(people[i].start);
      case 1:
        return move(people[i].route.back());
      case 2:
        return change(people[i].speed);
      case 3:
        return people.push_back(another(people, people[i]));
      default:
        people.erase(people.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

 private:
  std::size_t any_of(std::size_t count) {
    return static_cast<std::size_t>(uniform_int(engine_, 0, static_cast<int>(count) - 1));
  }
  void move(TPoint2D& point) {
    const double side = std::min(bounds_.width(), bounds_.height());
    const double sigma = sample_log_uniform(engine_, limits_.resolution, side / 3);
    const double dx = normal(engine_, 0, sigma), dy = normal(engine_, 0, sigma);
    point += TPoint2D(dx, dy);
  }
  void change(double& speed) {
    constexpr double kSlowest = 0.1, kFastest = 3;  // m/s
    speed = std::clamp(speed * math::exp(normal(engine_, 0, 0.3)), kSlowest, kFastest);
  }
  Person another(const People& people, Person person) {
    const auto is_taken = [&](const Person& other) { return other.id == person.id; };
    for (int i = 0; std::any_of(people.begin(), people.end(), is_taken); ++i)
      person.id = "person_" + std::to_string(i);
    person.start = sample_position(engine_, bounds_);
    person.route = {sample_position(engine_, bounds_)};
    return person;
  }

  Bounds bounds_;
  const MutationLimits& limits_;
  RandomEngine& engine_;
};

/// Whether all people, if there are some, can start and walk.
bool lets_people_walk(const Scenario& child, const MutationLimits& limits) {
  return child.people().empty() ||
         problem_of_people(World(child, limits.resolution), limits.robot_radius).empty();
}

/// None if the mutation does not apply.
std::optional<Scenario> changed(const Scenario& parent, Mutation mutation,
                                const MutationLimits& limits, RandomEngine& engine) {
  if (parent.representation() == Representation::Continuous)
    return mutate_scene(parent, mutation, limits, engine);
  if (mutation == Mutation::MoveStartGoal) return mutate_start_goal(parent, limits, engine);
  if (parent.representation() == Representation::Grid)
    return mutate_grid(parent, mutation, limits, engine);
  return std::nullopt;
}

}  // namespace

std::optional<Scenario> mutate(const Scenario& parent, Mutation mutation,
                               const MutationLimits& limits, RandomEngine& engine) {
  std::optional<Scenario> child;
  try {
    child = changed(parent, mutation, limits, engine);
  } catch (const Error&) {
    if (parent.people().empty()) throw;  // otherwise someone is not in the workspace anymore
  }
  if (!child) return std::nullopt;
  const auto& start = child->start();
  const double straight = distance_between(child->goal(), start);
  if (straight < limits.min_distance) return std::nullopt;
  if (!keeps_movers_free(parent, *child, limits)) return std::nullopt;
  if (!lets_people_walk(*child, limits)) return std::nullopt;
  return child;
}

std::optional<Scenario> mutate_people(const Scenario& parent, const MutationLimits& limits,
                                      RandomEngine& engine) {
  People people = parent.people();
  if (people.empty()) return std::nullopt;
  PeopleMutator(parent.bounds(), limits, engine).apply(people);
  try {
    Scenario child = parent.with_people(std::move(people));
    return lets_people_walk(child, limits) ? std::make_optional(std::move(child)) : std::nullopt;
  } catch (const Error&) {
    return std::nullopt;  // two overlap at the start
  }
}

}  // namespace slalom
