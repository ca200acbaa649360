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

/// The nearest column or row of a grid.
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

TPoint2D start_place(const Scenario& scenario) {
  return {scenario.start().x, scenario.start().y};
}

}  // namespace

std::string place_text(const TPoint2D& p) {
  return "(" + format_number(p.x) + ", " + format_number(p.y) + ")";
}

void refuse_edit(const Scenario& scenario, const std::string& what, const std::string& expected) {
  throw usage_error(scenario.name(), what, expected);
}

void expect_representation(const Scenario& scenario, Representation wanted,
                           const std::string& what) {
  if (scenario.representation() != wanted)
    refuse_edit(scenario,
                "is " + to_string(scenario.representation()) + ": " + what + " cannot be done",
                "a " + to_string(wanted) + " scenario, such as `convert` makes");
}

void expect_inside(const Scenario& scenario, const std::string& what, const TPoint2D& p) {
  const Bounds& b = scenario.bounds();
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !b.contains(p))
    refuse_edit(scenario, what + " at " + place_text(p) + " is outside the workspace",
                "a place within " + place_text({b.x_min, b.y_min}) + " to " +
                    place_text({b.x_max, b.y_max}));
}

bool is_covered(const Scenario& scenario, const TPoint2D& p) {
  if (scenario.representation() == Representation::Continuous)
    return on_primitive(scenario.primitives(), p);
  return scenario.representation() == Representation::Grid && on_occupied_cell(scenario, p);
}

void expect_free(const Scenario& scenario, const std::string& what, const TPoint2D& p) {
  expect_inside(scenario, what, p);
  if (is_covered(scenario, p))
    refuse_edit(scenario, what + " at " + place_text(p) + " is on an obstacle", "a free place");
}

void expect_uncovered(const Scenario& before, const Scenario& after) {
  const std::pair<const char*, TPoint2D> ends[] = {{"start", start_place(after)},
                                                   {"goal", after.goal()}};
  for (const auto& [what, p] : ends)
    if (is_covered(after, p) && !is_covered(before, p))
      refuse_edit(before,
                  std::string("an obstacle would cover the ") + what + " at " + place_text(p),
                  "obstacles beside start and goal");
}

}  // namespace slalom
