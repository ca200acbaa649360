// SPDX-License-Identifier: BSD-3-Clause
#include "scene_mutation.h"

#include <slalom/core/math.h>
#include <slalom/generation/start_goal.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// Applies a change to each point that defines an obstacle and to a disc's radius.
template <typename Point, typename Radius>
void change(Scene::Obstacle& obstacle, Point point, Radius radius) {
  if (Disc* disc = std::get_if<Disc>(&obstacle)) {
    point(disc->center);
    radius(disc->radius);
  } else {
    for (TPoint2D& vertex : std::get<Polygon>(obstacle).vertices) point(vertex);
  }
}

}  // namespace

Scene::Scene(const Scenario& scenario)
    : bounds(scenario.bounds()),
      start(scenario.start()),
      goal(scenario.goal()),
      movers(scenario.movers()),
      people(scenario.people()),
      goal_heading(scenario.goal_heading()) {
  for (const Disc& disc : scenario.primitives().discs) obstacles.emplace_back(disc);
  for (const Polygon& polygon : scenario.primitives().polygons) obstacles.emplace_back(polygon);
}

Scenario Scene::scenario(const std::string& name) const {
  Primitives primitives;
  for (const Obstacle& obstacle : obstacles)
    if (const Disc* disc = std::get_if<Disc>(&obstacle))
      primitives.discs.push_back(*disc);
    else
      primitives.polygons.push_back(std::get<Polygon>(obstacle));
  return Scenario::continuous(name, bounds, std::move(primitives), start, goal)
      .with_movers(movers)
      .with_people(people)
      .with_goal_heading(goal_heading);
}

TPoint2D center_of(const Scene::Obstacle& obstacle) {
  if (const Disc* disc = std::get_if<Disc>(&obstacle)) return disc->center;
  TPoint2D sum(0, 0);
  const auto& vertices = std::get<Polygon>(obstacle).vertices;
  for (const TPoint2D& vertex : vertices) sum += vertex;
  return sum * (1.0 / static_cast<double>(vertices.size()));
}

void translate(Scene::Obstacle& obstacle, double dx, double dy) {
  change(
      obstacle, [&](TPoint2D& p) { p += TPoint2D(dx, dy); }, [](double&) {});
}

void scale(Scene::Obstacle& obstacle, double factor) {
  const TPoint2D center = center_of(obstacle);
  change(
      obstacle, [&](TPoint2D& p) { p = center + (p - center) * factor; },
      [&](double& radius) { radius *= factor; });
}

void scale_about_origin(Scene::Obstacle& obstacle, double factor) {
  change(
      obstacle, [&](TPoint2D& p) { p = p * factor; }, [&](double& radius) { radius *= factor; });
}

double distance(const TPoint2D& p, const Scene::Obstacle& obstacle) {
  return std::visit([&](const auto& shape) { return distance(p, shape); }, obstacle);
}

std::vector<TPoint2D> sample_path(const Bounds& bounds, const TPose2D& start, const TPoint2D& goal,
                                  RandomEngine& engine) {
  std::vector<TPoint2D> path = {{start.x, start.y}};
  const double margin = std::min(bounds.width(), bounds.height()) / 10;
  for (int between = uniform_int(engine, 0, 2); between > 0; --between)
    path.push_back(sample_position(engine, bounds, margin));
  path.push_back(goal);
  return path;
}

double distance(const TPoint2D& p, const std::vector<TPoint2D>& path) {
  double min_distance = distance_to_segment(p, path[0], path[1]);
  for (std::size_t i = 2; i < path.size(); ++i)
    min_distance = std::min(min_distance, distance_to_segment(p, path[i - 1], path[i]));
  return min_distance;
}

double sample_log_uniform(RandomEngine& engine, double low, double high) {
  return math::exp(uniform_real(engine, math::log(low), math::log(std::max(low, high))));
}

void move_start_goal(const Bounds& bounds, const MutationLimits& limits, RandomEngine& engine,
                     TPose2D& start, TPoint2D& goal) {
  const double margin = limits.robot_radius + 2 * limits.resolution;
  const int which = uniform_int(engine, 0, 2);
  const double reach =
      sample_log_uniform(engine, 0.02, 2) * math::hypot(bounds.width(), bounds.height());
  const auto moved = [&](const TPoint2D& from) -> TPoint2D {
    const Bounds near = {
        std::max(bounds.x_min, from.x - reach), std::max(bounds.y_min, from.y - reach),
        std::min(bounds.x_max, from.x + reach), std::min(bounds.y_max, from.y + reach)};
    return sample_position(engine, near, std::min({margin, near.width() / 2, near.height() / 2}));
  };
  if (which != 0) goal = moved(goal);
  if (which != 1) {
    const TPoint2D at = moved({start.x, start.y});
    start = {at.x, at.y, start.phi};
  }
  start.phi = math::atan2(goal.y - start.y, goal.x - start.x);
}

}  // namespace slalom
