// SPDX-License-Identifier: BSD-3-Clause
#include "edit_checks.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slalom {

using mrpt::math::TPoint2D;

namespace {

bool on_primitive(const Primitives& obstacles, const TPoint2D& p) {
  const auto covers = [&p](const auto& obstacle) { return distance(p, obstacle) <= 0; };
  return std::any_of(obstacles.discs.begin(), obstacles.discs.end(), covers) ||
         std::any_of(obstacles.polygons.begin(), obstacles.polygons.end(), covers);
}

/// The column or row of a grid, clamped to its size.
int cell_of(double coordinate, double origin, double resolution, std::size_t size) {
  const double cell = std::floor((coordinate - origin) / resolution);
  return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(size) - 1));
}

bool on_occupied_cell(const Scenario& scenario, const TPoint2D& p) {
  const auto& map = *scenario.grid_map();
  const Bounds& b = scenario.bounds();
  const int cx = cell_of(p.x, b.x_min, map.getResolution(), map.getSizeX());
  const int cy = cell_of(p.y, b.y_min, map.getResolution(), map.getSizeY());
  return map.getCell(cx, cy) < 0.5F;
}

TPoint2D start_position(const Scenario& scenario) {
  return {scenario.start().x, scenario.start().y};
}

}  // namespace

std::string point_text(const TPoint2D& p) {
  return "(" + format_number(p.x) + ", " + format_number(p.y) + ")";
}

void refuse_edit(const Scenario& scenario, const std::string& what, const std::string& expected) {
  throw usage_error(scenario.name(), what, expected);
}

void expect_representation(const Scenario& scenario, Representation required,
                           const std::string& what) {
  if (scenario.representation() != required)
    refuse_edit(
        scenario,
        what + " is not supported for " + to_string(scenario.representation()) + " scenarios",
        "a " + to_string(required) + " scenario, see `convert`");
}

void expect_inside(const Scenario& scenario, const std::string& what, const TPoint2D& p) {
  const Bounds& b = scenario.bounds();
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !b.contains(p))
    refuse_edit(scenario, what + " at " + point_text(p) + " is outside the workspace",
                "a point within " + point_text({b.x_min, b.y_min}) + " to " +
                    point_text({b.x_max, b.y_max}));
}

bool is_covered(const Scenario& scenario, const TPoint2D& p) {
  if (scenario.representation() == Representation::Continuous)
    return on_primitive(scenario.primitives(), p);
  return scenario.representation() == Representation::Grid && on_occupied_cell(scenario, p);
}

void expect_free(const Scenario& scenario, const std::string& what, const TPoint2D& p) {
  expect_inside(scenario, what, p);
  if (is_covered(scenario, p))
    refuse_edit(scenario, what + " at " + point_text(p) + " is on an obstacle", "a free point");
}

void require_free_start_goal(const Scenario& before, const Scenario& after) {
  const std::pair<const char*, TPoint2D> points[] = {{"start", start_position(after)},
                                                     {"goal", after.goal()}};
  for (const auto& [what, p] : points)
    if (is_covered(after, p) && !is_covered(before, p))
      refuse_edit(before,
                  std::string("an obstacle would cover the ") + what + " at " + point_text(p),
                  "obstacles that leave start and goal free");
}

}  // namespace slalom
