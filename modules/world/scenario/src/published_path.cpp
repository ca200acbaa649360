// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/scenario/published_path.h>

#include <cmath>

namespace slalom {
namespace {

constexpr double kMaxFieldCells = 4e6;

int field_cells(double extent, double cell_size) {
  return static_cast<int>(std::lround(extent / cell_size));
}

bool fill(double extent, double cell_size) {
  const double cells = extent / cell_size;
  return cells > 0.5 && cells <= kMaxFieldCells && std::abs(cells - std::round(cells)) < 0.01;
}

bool good_field(const PublishedPath& path) {
  const Bounds& f = path.field;
  return std::isfinite(f.x_min) && std::isfinite(f.y_min) && std::isfinite(path.cell_size) &&
         path.cell_size > 0 && fill(f.width(), path.cell_size) &&
         fill(f.height(), path.cell_size) &&
         f.width() / path.cell_size * (f.height() / path.cell_size) <= kMaxFieldCells;
}

}  // namespace

int PublishedPath::size_x() const {
  return field_cells(field.width(), cell_size);
}

int PublishedPath::size_y() const {
  return field_cells(field.height(), cell_size);
}

std::string PublishedPath::hash() const {
  Hasher hasher;
  hasher.add(field.x_min).add(field.y_min).add(field.x_max).add(field.y_max).add(cell_size);
  for (const auto& p : points) hasher.add(p.x).add(p.y);
  return hasher.hex();
}

bool PublishedPath::operator==(const PublishedPath& other) const {
  return points == other.points && field == other.field && cell_size == other.cell_size;
}

void check_published_path(const std::string& name, const PublishedPath& path) {
  if (path.points.empty()) throw file_error(name, "the published path is empty", "points");
  for (std::size_t i = 0; i < path.points.size(); ++i)
    if (!std::isfinite(path.points[i].x) || !std::isfinite(path.points[i].y))
      throw file_error(name, "point " + std::to_string(i) + " of the published path is not finite",
                       "finite coordinates");
  if (!good_field(path))
    throw file_error(name, "the cells of the published path do not fill their field",
                     "a finite field of 1 to 4 million square cells");
}

}  // namespace slalom
