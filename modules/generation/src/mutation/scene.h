#pragma once

#include "mutation.h"

#include <slalom/scenario/geometry.h>

#include <algorithm>
#include <variant>
#include <vector>

namespace slalom {

/// A mutable continuous scenario, with obstacles of both kinds in one list.
struct Scene {
  using Obstacle = std::variant<Disc, Polygon>;

  explicit Scene(const Scenario& scenario);
  Scenario scenario(const std::string& name) const;
  /// Removes the obstacles that satisfy the condition.
  template <typename Condition>
  void remove_if(Condition condition) {
    obstacles.erase(std::remove_if(obstacles.begin(), obstacles.end(), condition), obstacles.end());
  }

  Bounds bounds;
  std::vector<Obstacle> obstacles;
  mrpt::math::TPose2D start;
  mrpt::math::TPoint2D goal;
};

inline double shorter_side(const Scene& scene) {
  return std::min(scene.bounds.width(), scene.bounds.height());
}
/// Clearance (m) kept around start, goal and paths.
inline double clearance_margin(const MutationLimits& limits) {
  return limits.robot_radius + 1.5 * limits.resolution;
}

mrpt::math::TPoint2D center_of(
    const Scene::Obstacle& obstacle);  ///< of a polygon: mean of its vertices
void translate(Scene::Obstacle& obstacle, double dx, double dy);
void scale(Scene::Obstacle& obstacle, double factor);               ///< about its center
void scale_about_origin(Scene::Obstacle& obstacle, double factor);  ///< about the world origin
double distance(const mrpt::math::TPoint2D& p, const Scene::Obstacle& obstacle);
Polygon make_block(double x_min, double y_min, double x_max, double y_max);

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
