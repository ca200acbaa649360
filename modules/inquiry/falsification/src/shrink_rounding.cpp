// SPDX-License-Identifier: BSD-3-Clause
#include "shrinker.h"

#include <slalom/generation/scene.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr std::array kUnits = {1.0, 0.5, 0.25, 0.1, 0.05, 0.01, 0.001};  // m

/// Decimal numbers are the nearest to what a person types: 0.3, not 3 * 0.1.
double rounded(double value, double unit) {
  return std::round(value / unit) / std::round(1 / unit);
}

TPoint2D rounded(const TPoint2D& point, double unit) {
  return {rounded(point.x, unit), rounded(point.y, unit)};
}

/// Radii are not rounded below `min_radius` (m): discs smaller than a cell look alike.
Scene::Obstacle rounded(const Scene::Obstacle& obstacle, double unit, double min_radius) {
  if (const Disc* disc = std::get_if<Disc>(&obstacle))
    return Disc{rounded(disc->center, unit),
                std::max({unit, min_radius, rounded(disc->radius, unit)})};
  Polygon polygon = std::get<Polygon>(obstacle);
  for (TPoint2D& vertex : polygon.vertices) vertex = rounded(vertex, unit);
  return polygon;
}

TPose2D rounded(const TPose2D& pose, double unit) {
  return {rounded(pose.x, unit), rounded(pose.y, unit), pose.phi};
}

/// A change of one element of a scenario, or of all, for a unit.
using Rounding = std::function<Scenario(const Scenario& scenario, double unit)>;

Scenario with_rounded_task(const Scenario& scenario, double unit, bool start, bool goal) {
  return scenario.with_start_goal(start ? rounded(scenario.start(), unit) : scenario.start(),
                                  goal ? rounded(scenario.goal(), unit) : scenario.goal());
}

Rounding of_obstacle(std::size_t obstacle, double cell) {
  return [obstacle, cell](const Scenario& scenario, double unit) {
    Scene scene(scenario);
    scene.obstacles[obstacle] = rounded(scene.obstacles[obstacle], unit, cell);
    return scene.scenario(scenario.name());
  };
}

Scenario round_all(const Scenario& scenario, double unit, double cell) {
  Scene scene(scenario);
  for (Scene::Obstacle& obstacle : scene.obstacles) obstacle = rounded(obstacle, unit, cell);
  return with_rounded_task(scene.scenario(scenario.name()), unit, true, true);
}

/// Radius (m) and speed (m/s) hardly change, so that a person remains one.
Rounding of_person(std::size_t person) {
  return [person](const Scenario& scenario, double unit) {
    constexpr double kCoarsest = 0.05;
    People people = scenario.people();
    Person& one = people[person];
    one.start = rounded(one.start, unit);
    for (TPoint2D& point : one.route) point = rounded(point, unit);
    one.begin = rounded(one.begin, unit);
    const double fine = std::min(unit, kCoarsest);
    one.radius = std::max(fine, rounded(one.radius, fine));
    one.speed = std::max(fine, rounded(one.speed, fine));
    return scenario.with_people(std::move(people));
  };
}

/// To the coarsest unit that is accepted.
bool round_to_units(Shrinker& shrinker, const Rounding& rounding) {
  for (const double unit : kUnits) {
    const Scenario before = shrinker.scenario();
    if (shrinker.accept([&] { return rounding(before, unit); })) return true;
  }
  return false;
}

/// Headings in radians with four digits.
bool round_heading(Shrinker& shrinker) {
  const Scenario& scenario = shrinker.scenario();
  const TPose2D start = scenario.start();
  for (const double unit : {90.0, 45.0, 15.0, 5.0, 1.0, 0.01}) {
    const double degrees = std::round(start.phi * 180 / M_PI / unit) * unit;
    const double phi = std::round(degrees * M_PI / 180 * 1e4) / 1e4;
    if (phi == start.phi) return false;
    if (shrinker.accept([&] {
          return scenario.with_start_goal({start.x, start.y, phi}, scenario.goal());
        }))
      return true;
  }
  return false;
}

}  // namespace

bool round_numbers(Shrinker& shrinker) {
  bool changed = false;
  if (shrinker.scenario().representation() == Representation::Continuous) {
    const double cell = shrinker.resolution();
    changed |= round_to_units(shrinker, [cell](const Scenario& scenario, double unit) {
      return round_all(scenario, unit, cell);
    });
    const std::size_t obstacles = Scene(shrinker.scenario()).obstacles.size();
    for (std::size_t i = 0; i < obstacles; ++i)
      changed |= round_to_units(shrinker, of_obstacle(i, cell));
  }
  for (std::size_t i = 0; i < shrinker.scenario().people().size(); ++i)
    changed |= round_to_units(shrinker, of_person(i));
  changed |= round_to_units(shrinker, [](const Scenario& scenario, double unit) {
    return with_rounded_task(scenario, unit, true, false);
  });
  changed |= round_to_units(shrinker, [](const Scenario& scenario, double unit) {
    return with_rounded_task(scenario, unit, false, true);
  });
  changed |= round_heading(shrinker);
  return changed;
}

}  // namespace slalom
