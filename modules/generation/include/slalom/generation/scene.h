// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

namespace slalom {

/// A mutable continuous scenario, with obstacles of both kinds in one list.
struct Scene {
  using Obstacle = std::variant<Disc, Polygon>;

  explicit Scene(const Scenario& scenario);  ///< requires Continuous
  /// Throws as Scenario::continuous().
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
  Movers movers;                       ///< kept as they are
  People people;                       ///< likewise
  std::optional<double> goal_heading;  ///< rad
};

mrpt::math::TPoint2D center_of(
    const Scene::Obstacle& obstacle);  ///< of a polygon: mean of its vertices
void translate(Scene::Obstacle& obstacle, double dx, double dy);
void scale(Scene::Obstacle& obstacle, double factor);               ///< about its center
void scale_about_origin(Scene::Obstacle& obstacle, double factor);  ///< about the world origin
double distance(const mrpt::math::TPoint2D& p, const Scene::Obstacle& obstacle);

}  // namespace slalom
