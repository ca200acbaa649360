// SPDX-License-Identifier: BSD-3-Clause
#include "rasterize.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kTouch = 1e-9;  ///< cells

/// The cells of a row (or the rows) 0..size-1 whose closed interval [c, c+1] meets [low, high].
struct Range {
  Range(double low, double high, int size)
      : first(static_cast<int>(std::clamp(std::ceil(low - kTouch) - 1, 0.0, double(size)))),
        last(static_cast<int>(std::clamp(std::floor(high + kTouch), -1.0, size - 1.0))) {}
  int first, last;
};

void occupy(const Range& columns, int cy, Occupancy& cells) {
  for (int cx = columns.first; cx <= columns.last; ++cx) cells.set_occupied(cx, cy, true);
}

/// Occupies, row by row, the cells under the part of the segment in the strip of the row.
void rasterize_edge(const TPoint2D& a, const TPoint2D& b, Occupancy& cells) {
  const TPoint2D &low = a.y <= b.y ? a : b, &high = a.y <= b.y ? b : a;
  const double height = high.y - low.y;
  const auto x_at = [&](double y) {
    const double fraction = std::clamp((y - low.y) / height, 0.0, 1.0);
    return low.x + fraction * (high.x - low.x);
  };
  const Range rows(low.y, high.y, cells.size_y());
  for (int cy = rows.first; cy <= rows.last; ++cy) {
    double x0 = low.x, x1 = high.x;
    if (height > 0) {
      x0 = x_at(cy - kTouch);
      x1 = x_at(cy + 1 + kTouch);
    }
    occupy(Range(std::min(x0, x1), std::max(x0, x1), cells.size_x()), cy, cells);
  }
}

/// Occupies the cells whose centers lie inside (even-odd rule on the row's center line).
void fill(const std::vector<TPoint2D>& vertices, Occupancy& cells) {
  std::vector<double> crossings;
  for (int cy = 0; cy < cells.size_y(); ++cy) {
    const double y = cy + 0.5;
    crossings.clear();
    for (std::size_t i = 0, j = vertices.size() - 1; i < vertices.size(); j = i++) {
      const TPoint2D &a = vertices[j], &b = vertices[i];
      if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const double first = std::max(0.0, std::ceil(crossings[i] - 0.5));
      const double last = std::min(cells.size_x() - 1.0, std::floor(crossings[i + 1] - 0.5));
      for (double cx = first; cx <= last; ++cx) cells.set_occupied(static_cast<int>(cx), cy, true);
    }
  }
}

}  // namespace

void rasterize(const Disc& disc, Occupancy& cells) {
  const TPoint2D center = cells.to_cells(disc.center);
  const double radius = disc.radius / cells.resolution() + kTouch;
  const Range rows(center.y - radius, center.y + radius, cells.size_y());
  for (int cy = rows.first; cy <= rows.last; ++cy) {
    const double gap = std::max({0.0, cy - center.y, center.y - (cy + 1)});
    const double half = std::sqrt(std::max(0.0, radius * radius - gap * gap));
    occupy(Range(center.x - half, center.x + half, cells.size_x()), cy, cells);
  }
}

void rasterize(const Polygon& polygon, Occupancy& cells) {
  std::vector<TPoint2D> vertices;
  for (const TPoint2D& vertex : polygon.vertices) vertices.push_back(cells.to_cells(vertex));
  for (std::size_t i = 0, j = vertices.size() - 1; i < vertices.size(); j = i++)
    rasterize_edge(vertices[j], vertices[i], cells);
  fill(vertices, cells);
}

}  // namespace slalom
