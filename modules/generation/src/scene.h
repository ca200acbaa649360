#pragma once

#include "mutation.h"

#include <slalom/scenario/geometry.h>

#include <algorithm>
#include <variant>
#include <vector>

namespace slalom {

/// A continuous scenario while it is being changed: obstacles of both kinds in one list.
struct Scene {
  using Obstacle = std::variant<Disc, Polygon>;

  explicit Scene(const Scenario& scenario);
  Scenario scenario(const std::string& name) const;
  /// Takes away the obstacles for which that holds.
  template <typename Condition>
  void drop_if(Condition condition) {
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
/// What must stay free about start, goal and ways, m.
inline double berth(const MutationLimits& limits) {
  return limits.robot_radius + 1.5 * limits.resolution;
}

mrpt::math::TPoint2D center_of(
    const Scene::Obstacle& obstacle);  ///< of a polygon: mean of vertices
void translate(Scene::Obstacle& obstacle, double dx, double dy);
void scale(Scene::Obstacle& obstacle, double factor);    ///< about its centre
void stretch(Scene::Obstacle& obstacle, double factor);  ///< about the origin of the plane
double distance(const mrpt::math::TPoint2D& p, const Scene::Obstacle& obstacle);
Polygon make_block(double x_min, double y_min, double x_max, double y_max);

/// A way from start to goal: straight, or over up to two places drawn within the bounds.
std::vector<mrpt::math::TPoint2D> draw_way(const Bounds& bounds, const mrpt::math::TPose2D& start,
                                           const mrpt::math::TPoint2D& goal, RandomEngine& engine);

/// Distance from a point to a way.
double distance(const mrpt::math::TPoint2D& p, const std::vector<mrpt::math::TPoint2D>& way);

/// Evenly in the logarithm.
double draw_length(RandomEngine& engine, double low, double high);

/// Moves start or goal, or both, to a place drawn within the bounds.
void move_task(const Bounds& bounds, const MutationLimits& limits, RandomEngine& engine,
               mrpt::math::TPose2D& start, mrpt::math::TPoint2D& goal);

/// Mutations of a continuous scene in place, by what they change; false where one does not apply.
bool mutate_obstacles(Scene& scene, Mutation mutation, const MutationLimits& limits,
                      RandomEngine& engine);
bool mutate_along_way(Scene& scene, Mutation mutation, const MutationLimits& limits,
                      RandomEngine& engine);  ///< from start to goal
bool mutate_floor(Scene& scene, Mutation mutation, const MutationLimits& limits,
                  RandomEngine& engine);

/// Mutations of grids, cell by cell, for those that apply to them.
std::optional<Scenario> mutate_grid(const Scenario& parent, Mutation mutation,
                                    const MutationLimits& limits, RandomEngine& engine);

}  // namespace slalom
