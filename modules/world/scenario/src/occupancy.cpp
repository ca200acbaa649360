// SPDX-License-Identifier: BSD-3-Clause
#include "rasterize.h"

#include <slalom/core/error.h>
#include <slalom/scenario/grid_map.h>
#include <slalom/scenario/occupancy.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPoint2D;

/// Relative tolerance of lengths: in MRPT's single precision 0.05 m is 0.05000000075 m, and a
/// scenario made from such a grid must have the same number of cells of 0.05 m again.
constexpr double kRelativeSlack = 1e-7;

int cells_along(double length, double resolution) {
  return static_cast<int>(std::ceil(length / resolution * (1 - kRelativeSlack)));
}

Occupancy empty_occupancy(const Scenario& scenario, double resolution) {
  if (!std::isfinite(resolution) || !(resolution > 0))
    throw usage_error("resolution", "invalid cell size", "a length above 0 m");
  const Bounds& b = scenario.bounds();
  if (!((b.width() / resolution + 1) * (b.height() / resolution + 1) <= kMaxGridCells)) {
    std::ostringstream what;
    what << resolution << " m is too fine for '" << scenario.name() << "' (" << b.width() << " m x "
         << b.height() << " m)";
    throw usage_error("resolution", what.str(), "at most 400 million cells");
  }
  return {cells_along(b.width(), resolution), cells_along(b.height(), resolution), resolution,
          TPoint2D(b.x_min, b.y_min)};
}

/// If the bounds are not a multiple of the cell size, the last cells extend beyond the workspace.
void occupy_beyond_bounds(const Bounds& bounds, Occupancy& cells) {
  const double columns = bounds.width() / cells.resolution() * (1 + kRelativeSlack);
  const double rows = bounds.height() / cells.resolution() * (1 + kRelativeSlack);
  if (cells.size_x() > columns)
    for (int cy = 0; cy < cells.size_y(); ++cy) cells.set_occupied(cells.size_x() - 1, cy, true);
  if (cells.size_y() > rows)
    for (int cx = 0; cx < cells.size_x(); ++cx) cells.set_occupied(cx, cells.size_y() - 1, true);
}

Occupancy from_primitives(const Scenario& scenario, double resolution) {
  Occupancy cells = empty_occupancy(scenario, resolution);
  for (const Disc& disc : scenario.primitives().discs) rasterize(disc, cells);
  for (const Polygon& polygon : scenario.primitives().polygons) rasterize(polygon, cells);
  occupy_beyond_bounds(scenario.bounds(), cells);
  return cells;
}

Occupancy from_points(const Scenario& scenario, double resolution) {
  Occupancy cells = empty_occupancy(scenario, resolution);
  const auto& x = scenario.point_map()->getPointsBufferRef_x();
  const auto& y = scenario.point_map()->getPointsBufferRef_y();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!scenario.bounds().contains(TPoint2D(x[i], y[i]))) continue;
    const TPoint2D at = cells.to_cells(TPoint2D(x[i], y[i]));
    cells.set_occupied(std::min(static_cast<int>(at.x), cells.size_x() - 1),
                       std::min(static_cast<int>(at.y), cells.size_y() - 1), true);
  }
  occupy_beyond_bounds(scenario.bounds(), cells);
  return cells;
}

Occupancy from_grid(const COccupancyGridMap2D& map) {
  Occupancy cells(static_cast<int>(map.getSizeX()), static_cast<int>(map.getSizeY()),
                  map.getResolution(), TPoint2D(map.getXMin(), map.getYMin()));
  const auto unknown = COccupancyGridMap2D::p2l(0.5f);
  for (int cy = 0; cy < cells.size_y(); ++cy) {
    const auto* row = map.getRow(cy);
    for (int cx = 0; cx < cells.size_x(); ++cx)
      if (row[cx] <= unknown) cells.set_occupied(cx, cy, true);
  }
  return cells;
}

/// Layout that is written for other processes.
struct Geometry {
  int size_x, size_y;
  double resolution, x, y;
};

}  // namespace

Occupancy::Occupancy(int size_x, int size_y, double resolution, TPoint2D origin)
    : size_x_(size_x), size_y_(size_y), resolution_(resolution), origin_(origin) {
  if (size_x < 1 || size_y < 1 || static_cast<double>(size_x) * size_y > kMaxGridCells)
    throw usage_error("grid", std::to_string(size_x) + " x " + std::to_string(size_y) + " cells",
                      "1 to 400 million cells");
  cells_.assign(static_cast<std::size_t>(size_x) * static_cast<std::size_t>(size_y), 0);
}

void Occupancy::write(ArrayWriter& writer) const {
  const Geometry geometry = {size_x_, size_y_, resolution_, origin_.x, origin_.y};
  writer.write(&geometry, 1);
  writer.write(cells_.data(), cells_.size());
}

Occupancy Occupancy::read(ArrayReader& reader) {
  const Geometry geometry = reader.read<Geometry>(1)[0];
  Occupancy occupancy(geometry.size_x, geometry.size_y, geometry.resolution,
                      {geometry.x, geometry.y});
  const auto cells = reader.read<std::uint8_t>(occupancy.cells_.size());
  std::copy(cells.begin(), cells.end(), occupancy.cells_.begin());
  return occupancy;
}

Bounds Occupancy::bounds() const {
  return {origin_.x, origin_.y, origin_.x + size_x_ * resolution_,
          origin_.y + size_y_ * resolution_};
}

void Occupancy::set_occupied(int cx, int cy, bool occupied) {
  cells_[index(cx, cy)] = occupied ? 1 : 0;
}

std::size_t Occupancy::count_occupied() const {
  std::size_t count = 0;
  for (const std::uint8_t cell : cells_) count += cell;
  return count;
}

Occupancy make_occupancy(const Scenario& scenario, double resolution) {
  switch (scenario.representation()) {
    case Representation::Grid:
      return from_grid(*scenario.grid_map());
    case Representation::Points:
      return from_points(scenario, resolution);
    case Representation::Continuous:
      break;
  }
  return from_primitives(scenario, resolution);
}

}  // namespace slalom
