#include "lattice.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kSpacing = 1;  ///< m

std::vector<double> lattice_along(double low, double high, double spacing) {
  const double count = std::max(1.0, std::floor((high - low) / spacing * (1 + 1e-9)));
  std::vector<double> points;
  for (double i = 0; i < count; ++i)
    points.push_back(0.5 * (low + high) + (i - 0.5 * (count - 1)) * spacing);
  return points;
}

}  // namespace

std::vector<mrpt::math::TPoint2D> lattice_points(const Occupancy& cells) {
  const Bounds bounds = cells.bounds();
  const double spacing = std::max(kSpacing, cells.resolution());
  const std::vector<double> columns = lattice_along(bounds.x_min, bounds.x_max, spacing);
  std::vector<mrpt::math::TPoint2D> points;
  for (const double y : lattice_along(bounds.y_min, bounds.y_max, spacing))
    for (const double x : columns) points.emplace_back(x, y);
  return points;
}

}  // namespace slalom
