// SPDX-License-Identifier: BSD-3-Clause
#include "contours.h"

#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/scenario/convert.h>
#include <slalom/scenario/grid_map.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace slalom {
namespace {

using mrpt::maps::CSimplePointsMap;
using mrpt::math::TPoint2D;

constexpr double kMaxPoints = 100e6;

Scenario to_grid(const Scenario& scenario, double resolution) {
  const Occupancy cells = make_occupancy(scenario, resolution);
  auto map = make_grid_map(cells.size_x(), cells.size_y(), resolution, cells.origin());
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx)
      if (cells.occupied(cx, cy)) map.setCell(cx, cy, 0.0f);
  return Scenario::grid(scenario.name(), map, scenario.start(), scenario.goal());
}

/// Collects the points that lie in the workspace.
class PointCollector {
 public:
  explicit PointCollector(const Bounds& bounds) : bounds_(bounds) {}

  void add(const TPoint2D& p) {
    if (bounds_.contains(p)) map_.insertPoint(static_cast<float>(p.x), static_cast<float>(p.y));
  }
  const CSimplePointsMap& map() const { return map_; }

 private:
  Bounds bounds_;
  CSimplePointsMap map_;
};

double pieces(double length, double spacing) {
  return std::max(1.0, std::ceil(length / spacing * (1 - 1e-9)));
}

void sample(const Disc& disc, double spacing, PointCollector& points) {
  const double n = std::max(3.0, pieces(2 * M_PI * disc.radius, spacing));
  for (double i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * i / n;
    points.add({disc.center.x + disc.radius * math::cos(angle),
                disc.center.y + disc.radius * math::sin(angle)});
  }
}

void sample(const Polygon& polygon, double spacing, PointCollector& points) {
  const auto& v = polygon.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const TPoint2D &a = v[i], &b = v[(i + 1) % v.size()];
    const double n = pieces(distance_between(b, a), spacing);
    for (double k = 0; k < n; ++k)
      points.add({a.x + k / n * (b.x - a.x), a.y + k / n * (b.y - a.y)});
  }
}

double boundary_length(const Primitives& obstacles) {
  double length = 0;
  for (const Disc& disc : obstacles.discs) length += 2 * M_PI * disc.radius;
  for (const Polygon& polygon : obstacles.polygons) {
    const auto& v = polygon.vertices;
    for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++)
      length += distance_between(v[i], v[j]);
  }
  return length;
}

void sample_boundaries(const Scenario& scenario, double spacing, PointCollector& points) {
  const Primitives& obstacles = scenario.primitives();
  if (!(spacing > 0) || !(boundary_length(obstacles) / spacing <= kMaxPoints)) {
    std::ostringstream what;
    what << "invalid spacing " << spacing << " m of the points of '" << scenario.name() << "'";
    throw usage_error("resolution", what.str(), "a length above 0 m, at most 100 million points");
  }
  for (const Disc& disc : obstacles.discs) sample(disc, spacing, points);
  for (const Polygon& polygon : obstacles.polygons) sample(polygon, spacing, points);
}

void sample_border_cells(const Occupancy& cells, PointCollector& points) {
  const auto is_free = [&](int cx, int cy) {
    return cells.inside(cx, cy) && !cells.occupied(cx, cy);
  };
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx)
      if (cells.occupied(cx, cy) && (is_free(cx - 1, cy) || is_free(cx + 1, cy) ||
                                     is_free(cx, cy - 1) || is_free(cx, cy + 1)))
        points.add(cells.cell_center(cx, cy));
}

Scenario to_points(const Scenario& scenario, double spacing) {
  PointCollector points(scenario.bounds());
  if (scenario.representation() == Representation::Continuous)
    sample_boundaries(scenario, spacing, points);
  else
    sample_border_cells(make_occupancy(scenario, spacing), points);
  return Scenario::points(scenario.name(), scenario.bounds(), points.map(), scenario.start(),
                          scenario.goal());
}

Scenario to_continuous(const Scenario& scenario, const ConversionOptions& options) {
  Primitives obstacles;
  if (scenario.representation() == Representation::Grid) {
    obstacles.polygons = trace_contours(make_occupancy(scenario, 1), options.tolerance);
  } else {
    const double radius = options.point_radius > 0 ? options.point_radius : options.resolution / 2;
    if (!(radius > 0) || !std::isfinite(radius))
      throw usage_error("point_radius", "invalid radius " + format_number(radius) + " m",
                        "a radius above 0 m");
    const auto &x = scenario.point_map()->getPointsBufferRef_x(),
               &y = scenario.point_map()->getPointsBufferRef_y();
    for (std::size_t i = 0; i < x.size(); ++i)
      obstacles.discs.push_back({TPoint2D(x[i], y[i]), radius});
  }
  return Scenario::continuous(scenario.name(), scenario.bounds(), std::move(obstacles),
                              scenario.start(), scenario.goal());
}

}  // namespace

Scenario convert(const Scenario& scenario, Representation to, const ConversionOptions& options) {
  if (to == scenario.representation()) return scenario;
  const auto converted = [&] {
    if (to == Representation::Grid) return to_grid(scenario, options.resolution);
    if (to == Representation::Points) return to_points(scenario, options.resolution);
    return to_continuous(scenario, options);
  };
  return converted().with_rest_of(scenario).with_published_path(scenario.published_path());
}

Scenario convert(const Scenario& scenario, Representation to, double resolution) {
  ConversionOptions options;
  options.resolution = resolution;
  return convert(scenario, to, options);
}

}  // namespace slalom
