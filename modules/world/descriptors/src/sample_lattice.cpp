// SPDX-License-Identifier: BSD-3-Clause
#include "sample_lattice.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kSpacing = 1;  ///< m

/// Cells: sqrt(5) - 2. Points of the lattice lie at simple fractions of a cell, often on the line
/// between two; at an irrational distance from these they lie on none, and neither do lines through
/// them in the directions of mean_free_ray().
constexpr double kShift = 0.2360679774997897;

/// Grids hold the cell size, and so the extent of the workspace, in single precision.
constexpr double kSpacingRounding = 1e-6;

std::vector<double> lattice_along(double low, double high, double spacing, double shift) {
  const double count = std::max(1.0, std::floor((high - low) / spacing * (1 + kSpacingRounding)));
  std::vector<double> points;
  for (double i = 0; i < count; ++i)
    for (const double side : {-shift, shift})
      points.push_back(0.5 * (low + high) + (i - 0.5 * (count - 1)) * spacing + side);
  return points;
}

}  // namespace

std::vector<mrpt::math::TPoint2D> lattice_points(const Occupancy& cells) {
  const Bounds bounds = cells.bounds();
  const double spacing = std::max(kSpacing, cells.resolution());
  const double shift = kShift * cells.resolution();
  const std::vector<double> columns = lattice_along(bounds.x_min, bounds.x_max, spacing, shift);
  std::vector<mrpt::math::TPoint2D> points;
  for (const double y : lattice_along(bounds.y_min, bounds.y_max, spacing, shift))
    for (const double x : columns) points.emplace_back(x, y);
  return points;
}

}  // namespace slalom
