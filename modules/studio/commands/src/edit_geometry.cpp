// SPDX-License-Identifier: BSD-3-Clause
#include "edit_checks.h"

#include <slalom/commands/edit_geometry.h>
#include <slalom/core/geometry.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

bool touches(const Bounds& b, const Disc& disc) {
  const TPoint2D nearest(std::clamp(disc.center.x, b.x_min, b.x_max),
                         std::clamp(disc.center.y, b.y_min, b.y_max));
  return (nearest - disc.center).norm() <= disc.radius;
}

bool touches(const Bounds& b, const Polygon& polygon) {
  const auto inside = [&b](const TPoint2D& p) { return b.contains(p); };
  if (std::any_of(polygon.vertices.begin(), polygon.vertices.end(), inside)) return true;
  // No vertex inside: the box may be inside the polygon, or an edge may cross the box.
  const Polygon box{
      {{b.x_min, b.y_min}, {b.x_max, b.y_min}, {b.x_max, b.y_max}, {b.x_min, b.y_max}}};
  for (const TPoint2D& corner : box.vertices)
    if (contains(polygon, corner)) return true;
  const auto meets = [](const TPoint2D& p, const TPoint2D& q, const TPoint2D& r,
                        const TPoint2D& s) {
    const auto side = [](const TPoint2D& a, const TPoint2D& o, const TPoint2D& c) {
      return (o.x - a.x) * (c.y - a.y) - (o.y - a.y) * (c.x - a.x);
    };
    return side(p, q, r) * side(p, q, s) <= 0 && side(r, s, p) * side(r, s, q) <= 0;
  };
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      if (meets(polygon.vertices[i], polygon.vertices[(i + 1) % polygon.vertices.size()],
                box.vertices[k], box.vertices[(k + 1) % 4]))
        return true;
  return false;
}

void expect_valid(const Scenario& scenario, const Disc& disc) {
  if (!is_finite(disc.center) || !std::isfinite(disc.radius) || !(disc.radius > 0))
    refuse_edit(scenario, "a disc of radius " + format_number(disc.radius) + " m is degenerate",
                "a finite center and a positive radius");
  if (!touches(scenario.bounds(), disc))
    refuse_edit(scenario,
                "the obstacle at " + point_text(disc.center) + " is outside the workspace",
                "an obstacle that touches the workspace");
}

void expect_valid(const Scenario& scenario, const Polygon& polygon) {
  if (!std::all_of(polygon.vertices.begin(), polygon.vertices.end(), is_finite) ||
      !is_simple(polygon))
    refuse_edit(
        scenario,
        "a polygon of " + std::to_string(polygon.vertices.size()) + " vertices is degenerate",
        "at least 3 vertices, positive area and no crossing edges");
  if (!touches(scenario.bounds(), polygon))
    refuse_edit(
        scenario,
        "the obstacle at " + point_text(polygon.vertices.front()) + " is outside the workspace",
        "an obstacle that touches the workspace");
}

Scenario with_primitives(const Scenario& scenario, Primitives obstacles) {
  Scenario edited = Scenario::continuous(scenario.name(), scenario.bounds(), std::move(obstacles),
                                         scenario.start(), scenario.goal())
                        .with_rest_of(scenario);
  require_free_start_goal(scenario, edited);
  return edited;
}

/// Rejects an invalid obstacle index.
void expect_obstacle(const Scenario& scenario, std::size_t index) {
  expect_representation(scenario, Representation::Continuous, "editing obstacles");
  const std::size_t count = obstacle_count(scenario.primitives());
  if (index >= count)
    refuse_edit(scenario, "unknown obstacle " + std::to_string(index),
                count == 0 ? "a scenario with obstacles" : "0 to " + std::to_string(count - 1));
}

double distance_to(const Primitives& obstacles, std::size_t index, const TPoint2D& p) {
  const std::size_t discs = obstacles.discs.size();
  return index < discs ? distance(p, obstacles.discs[index])
                       : distance(p, obstacles.polygons[index - discs]);
}

}  // namespace

Scenario with_start(const Scenario& scenario, const TPose2D& start) {
  expect_free(scenario, "start", {start.x, start.y});
  if (!std::isfinite(start.phi))
    refuse_edit(scenario, "the start heading is not finite", "an angle");
  return scenario.with_start_goal(start, scenario.goal());
}

Scenario with_goal(const Scenario& scenario, const TPoint2D& goal) {
  expect_free(scenario, "goal", goal);
  return scenario.with_start_goal(scenario.start(), goal);
}

std::size_t obstacle_count(const Primitives& obstacles) {
  return obstacles.discs.size() + obstacles.polygons.size();
}

std::optional<std::size_t> obstacle_at(const Scenario& scenario, const TPoint2D& point,
                                       double tolerance) {
  if (scenario.representation() != Representation::Continuous) return std::nullopt;
  const Primitives& obstacles = scenario.primitives();
  std::optional<std::size_t> nearest;
  double min_distance = tolerance;
  for (std::size_t i = obstacle_count(obstacles); i-- > 0;) {
    const double d = distance_to(obstacles, i, point);
    if (d <= 0) return i;
    if (d > min_distance || (nearest && d == min_distance)) continue;
    nearest = i;
    min_distance = d;
  }
  return nearest;
}

Scenario with_obstacle_added(const Scenario& scenario, const Disc& disc) {
  expect_representation(scenario, Representation::Continuous, "adding a disc");
  expect_valid(scenario, disc);
  Primitives obstacles = scenario.primitives();
  obstacles.discs.push_back(disc);
  return with_primitives(scenario, std::move(obstacles));
}

Scenario with_obstacle_added(const Scenario& scenario, const Polygon& polygon) {
  expect_representation(scenario, Representation::Continuous, "adding a polygon");
  expect_valid(scenario, polygon);
  Primitives obstacles = scenario.primitives();
  obstacles.polygons.push_back(polygon);
  return with_primitives(scenario, std::move(obstacles));
}

Scenario with_obstacle_moved(const Scenario& scenario, std::size_t index, double dx, double dy) {
  expect_obstacle(scenario, index);
  Primitives obstacles = scenario.primitives();
  if (index < obstacles.discs.size()) {
    obstacles.discs[index].center += TPoint2D(dx, dy);
    expect_valid(scenario, obstacles.discs[index]);
  } else {
    Polygon& polygon = obstacles.polygons[index - obstacles.discs.size()];
    for (TPoint2D& vertex : polygon.vertices) vertex += TPoint2D(dx, dy);
    expect_valid(scenario, polygon);
  }
  return with_primitives(scenario, std::move(obstacles));
}

Scenario with_obstacle_removed(const Scenario& scenario, std::size_t index) {
  expect_obstacle(scenario, index);
  Primitives obstacles = scenario.primitives();
  if (index < obstacles.discs.size())
    obstacles.discs.erase(obstacles.discs.begin() + static_cast<std::ptrdiff_t>(index));
  else
    obstacles.polygons.erase(obstacles.polygons.begin() +
                             static_cast<std::ptrdiff_t>(index - obstacles.discs.size()));
  return with_primitives(scenario, std::move(obstacles));
}

}  // namespace slalom
