#pragma once

#include "mutation.h"

#include <slalom/scenario/geometry.h>

#include <variant>
#include <vector>

namespace slalom {

/// A continuous scenario while it is being changed: obstacles of both kinds in one list.
struct Scene {
  using Obstacle = std::variant<Disc, Polygon>;

  explicit Scene(const Scenario& scenario);
  Scenario scenario(const std::string& name) const;

  Bounds bounds;
  std::vector<Obstacle> obstacles;
  mrpt::math::TPose2D start;
  mrpt::math::TPoint2D goal;
};

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

/// Mutations of grids, cell by cell, for those that apply to them.
std::optional<Scenario> mutate_grid(const Scenario& parent, Mutation mutation,
                                    const MutationLimits& limits, RandomEngine& engine);

}  // namespace slalom
