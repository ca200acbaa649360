// SPDX-License-Identifier: BSD-3-Clause
#include "edit_checks.h"

#include <slalom/commands/edit_geometry.h>
#include <slalom/core/geometry.h>

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::maps::CSimplePointsMap;
using mrpt::math::TPoint2D;

void expect_valid(const Scenario& scenario, const Stroke& stroke) {
  if (stroke.points.empty() || !std::all_of(stroke.points.begin(), stroke.points.end(), is_finite))
    refuse_edit(scenario, "the stroke has no finite points", "one or more finite points");
  if (!std::isfinite(stroke.radius) || stroke.radius < 0)
    refuse_edit(scenario, "invalid brush radius", "a radius of 0 or more");
}

/// Whether the brush, moved from a to b, covers p.
bool is_under(const TPoint2D& p, const TPoint2D& a, const TPoint2D& b, double radius) {
  return distance_to_segment(p, a, b) <= radius;
}

/// Paints cells of a grid map.
class CellBrush {
 public:
  CellBrush(COccupancyGridMap2D& map, const Bounds& bounds, bool occupied)
      : map_(map),
        bounds_(bounds),
        resolution_(map.getResolution()),
        value_(COccupancyGridMap2D::p2l(occupied ? 0.0F : 1.0F)) {}

  void paint_cell(const TPoint2D& p) {
    if (!bounds_.contains(p)) return;
    const int cx = column(p.x), cy = row(p.y);
    map_.getRow(cy)[cx] = value_;
  }

  void paint_segment(const TPoint2D& a, const TPoint2D& b, double radius) {
    const int last_x = column(std::max(a.x, b.x) + radius);
    const int last_y = row(std::max(a.y, b.y) + radius);
    for (int cy = row(std::min(a.y, b.y) - radius); cy <= last_y; ++cy) {
      auto* cells = map_.getRow(cy);
      for (int cx = column(std::min(a.x, b.x) - radius); cx <= last_x; ++cx)
        if (is_under(center(cx, cy), a, b, radius)) cells[cx] = value_;
    }
  }

 private:
  /// The cell index, clamped to the grid.
  int clamped(double coordinate, double origin, std::size_t size) const {
    const double cell = std::floor((coordinate - origin) / resolution_);
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(size) - 1));
  }
  int column(double x) const { return clamped(x, bounds_.x_min, map_.getSizeX()); }
  int row(double y) const { return clamped(y, bounds_.y_min, map_.getSizeY()); }
  TPoint2D center(int cx, int cy) const {
    return {bounds_.x_min + (cx + 0.5) * resolution_, bounds_.y_min + (cy + 0.5) * resolution_};
  }

  COccupancyGridMap2D& map_;
  Bounds bounds_;
  double resolution_;
  COccupancyGridMap2D::cellType value_;
};

/// Visits the segments between consecutive points; a single point is a segment of length 0.
template <typename Visit>
void each_segment(const Stroke& stroke, Visit visit) {
  for (std::size_t i = 0; i < stroke.points.size(); ++i)
    visit(stroke.points[i], stroke.points[std::min(i + 1, stroke.points.size() - 1)]);
}

Scenario with_point_map(const Scenario& scenario, const CSimplePointsMap& map) {
  return Scenario::points(scenario.name(), scenario.bounds(), map, scenario.start(),
                          scenario.goal())
      .with_rest_of(scenario);
}

}  // namespace

Scenario with_cells_painted(const Scenario& scenario, const Stroke& stroke, bool occupied) {
  expect_representation(scenario, Representation::Grid, "painting cells");
  expect_valid(scenario, stroke);
  COccupancyGridMap2D map;
  map.copyMapContentFrom(*scenario.grid_map());
  CellBrush brush(map, scenario.bounds(), occupied);
  for (const TPoint2D& p : stroke.points) brush.paint_cell(p);
  each_segment(stroke, [&](const TPoint2D& a, const TPoint2D& b) {
    brush.paint_segment(a, b, stroke.radius);
  });
  Scenario edited = Scenario::grid(scenario.name(), map, scenario.start(), scenario.goal())
                        .with_rest_of(scenario);
  require_free_start_goal(scenario, edited);
  return edited;
}

Scenario with_points_added(const Scenario& scenario, const std::vector<TPoint2D>& points) {
  expect_representation(scenario, Representation::Points, "adding points");
  CSimplePointsMap map = *scenario.point_map();
  for (const TPoint2D& p : points) {
    expect_inside(scenario, "a point", p);
    map.insertPoint(static_cast<float>(p.x), static_cast<float>(p.y), 0.0F);
  }
  return with_point_map(scenario, map);
}

Scenario with_points_removed(const Scenario& scenario, const Stroke& stroke) {
  expect_representation(scenario, Representation::Points, "removing points");
  expect_valid(scenario, stroke);
  const auto &x = scenario.point_map()->getPointsBufferRef_x(),
             &y = scenario.point_map()->getPointsBufferRef_y();
  CSimplePointsMap remaining;
  for (std::size_t i = 0; i < x.size(); ++i) {
    bool keep = true;
    each_segment(stroke, [&](const TPoint2D& a, const TPoint2D& b) {
      keep = keep && !is_under({x[i], y[i]}, a, b, stroke.radius);
    });
    if (keep) remaining.insertPoint(x[i], y[i], 0.0F);
  }
  return with_point_map(scenario, remaining);
}

}  // namespace slalom
