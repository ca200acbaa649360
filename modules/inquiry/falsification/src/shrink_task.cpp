// SPDX-License-Identifier: BSD-3-Clause
#include "shrinker.h"

#include <slalom/generation/scene.h>
#include <slalom/scenario/grid_map.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// The start moves to the pose of the run that is nearest to its end.
bool move_start(Shrinker& shrinker) {
  const std::vector<TPose2D> poses = shrinker.trial().waypoints;
  for (std::size_t i = poses.size(); i-- > 1;)
    if (shrinker.accept([&] {
          return shrinker.scenario().with_start_goal(poses[i], shrinker.scenario().goal());
        }))
      return true;
  return false;
}

/// The goal moves towards the start.
bool move_goal(Shrinker& shrinker) {
  constexpr std::array kFractions = {0.3, 0.5, 0.7, 0.85};
  const TPose2D start = shrinker.scenario().start();
  const TPoint2D goal = shrinker.scenario().goal(), from(start.x, start.y);
  return std::any_of(kFractions.begin(), kFractions.end(), [&](double fraction) {
    return shrinker.accept([&] {
      return shrinker.scenario().with_start_goal(start, from + (goal - from) * fraction);
    });
  });
}

/// The rectangle around the run, start and goal, and the routes of people.
Bounds extent_of_run(Shrinker& shrinker) {
  const TPoint2D goal = shrinker.scenario().goal();
  const TPose2D start = shrinker.scenario().start();
  Bounds extent{std::min(start.x, goal.x), std::min(start.y, goal.y), std::max(start.x, goal.x),
                std::max(start.y, goal.y)};
  const auto include = [&extent](double x, double y) {
    extent.x_min = std::min(extent.x_min, x);
    extent.y_min = std::min(extent.y_min, y);
    extent.x_max = std::max(extent.x_max, x);
    extent.y_max = std::max(extent.y_max, y);
  };
  for (const TPose2D& pose : shrinker.trial().waypoints) include(pose.x, pose.y);
  for (const Person& person : shrinker.scenario().people())
    for (const TPoint2D& point : stations_of(person)) include(point.x, point.y);
  return extent;
}

bool overlaps(const Bounds& bounds, const Scene::Obstacle& obstacle) {
  Bounds box;
  if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
    const TPoint2D& c = disc->center;
    const double r = disc->radius;
    box = {c.x - r, c.y - r, c.x + r, c.y + r};
  } else {
    const auto& vertices = std::get<Polygon>(obstacle).vertices;
    box = {vertices[0].x, vertices[0].y, vertices[0].x, vertices[0].y};
    for (const TPoint2D& v : vertices)
      box = {std::min(box.x_min, v.x), std::min(box.y_min, v.y), std::max(box.x_max, v.x),
             std::max(box.y_max, v.y)};
  }
  return box.x_min <= bounds.x_max && box.x_max >= bounds.x_min && box.y_min <= bounds.y_max &&
         box.y_max >= bounds.y_min;
}

Scenario crop_grid(const Scenario& scenario, const Bounds& to) {
  const auto& map = *scenario.grid_map();
  const double cell = map.getResolution();
  const Bounds& from = scenario.bounds();
  const int left = static_cast<int>(std::lround((to.x_min - from.x_min) / cell));
  const int bottom = static_cast<int>(std::lround((to.y_min - from.y_min) / cell));
  const int size_x = static_cast<int>(std::lround(to.width() / cell));
  const int size_y = static_cast<int>(std::lround(to.height() / cell));
  auto cropped =
      make_grid_map(size_x, size_y, cell, {from.x_min + left * cell, from.y_min + bottom * cell});
  for (int y = 0; y < size_y; ++y)
    for (int x = 0; x < size_x; ++x) cropped.setCell(x, y, map.getCell(left + x, bottom + y));
  return Scenario::grid(scenario.name(), cropped, scenario.start(), scenario.goal())
      .with_rest_of(scenario);
}

Scenario crop(const Scenario& scenario, const Bounds& to) {
  if (scenario.representation() == Representation::Grid) return crop_grid(scenario, to);
  if (scenario.representation() == Representation::Points) {
    mrpt::maps::CSimplePointsMap inside;
    for (std::size_t i = 0; i < scenario.point_map()->size(); ++i) {
      float x = 0, y = 0;
      scenario.point_map()->getPoint(i, x, y);
      if (to.contains({x, y})) inside.insertPoint(x, y);
    }
    return Scenario::points(scenario.name(), to, inside, scenario.start(), scenario.goal())
        .with_rest_of(scenario);
  }
  Scene scene(scenario);
  scene.bounds = to;
  scene.remove_if([&](const Scene::Obstacle& obstacle) { return !overlaps(to, obstacle); });
  return scene.scenario(scenario.name());
}

/// `extent` with a margin on the sides that are chosen, on multiples of a quarter of a meter,
/// within the workspace.
Bounds with_margin(const Bounds& workspace, const Bounds& extent, double margin, unsigned sides) {
  constexpr double kUnit = 0.25;  // m
  const auto down = [](double x) { return std::floor(x / kUnit) * kUnit; };
  const auto up = [](double x) { return std::ceil(x / kUnit) * kUnit; };
  Bounds to = workspace;
  if ((sides & 1U) != 0) to.x_min = std::max(to.x_min, down(extent.x_min - margin));
  if ((sides & 2U) != 0) to.y_min = std::max(to.y_min, down(extent.y_min - margin));
  if ((sides & 4U) != 0) to.x_max = std::min(to.x_max, up(extent.x_max + margin));
  if ((sides & 8U) != 0) to.y_max = std::min(to.y_max, up(extent.y_max + margin));
  return to;
}

}  // namespace

bool move_start_and_goal(Shrinker& shrinker) {
  const bool start = move_start(shrinker);
  const bool goal = move_goal(shrinker);
  return start || goal;
}

bool crop_workspace(Shrinker& shrinker) {
  constexpr std::array kMargins = {1.5, 2.0, 3.0};  // m; walls nearer than that replace obstacles
  constexpr unsigned kAll = 15;
  bool changed = false;
  for (const unsigned sides : {kAll, 1U, 2U, 4U, 8U}) {
    const Bounds extent = extent_of_run(shrinker);
    const bool cropped = std::any_of(kMargins.begin(), kMargins.end(), [&](double margin) {
      const Scenario& scenario = shrinker.scenario();
      return shrinker.accept(
          [&] { return crop(scenario, with_margin(scenario.bounds(), extent, margin, sides)); });
    });
    changed |= cropped;
    if (cropped && sides == kAll) break;
  }
  return changed;
}

}  // namespace slalom
