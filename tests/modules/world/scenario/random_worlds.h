// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/scenario/occupancy.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace slalom::testing {

/// Cells of which a random fraction (often 0 or small) is occupied, with random origin and size.
inline Occupancy random_occupancy(RandomEngine& random, int largest) {
  Occupancy cells(uniform_int(random, 1, largest), uniform_int(random, 1, largest),
                  uniform_real(random, 0.03, 0.4),
                  {uniform_real(random, -9, 9), uniform_real(random, -9, 9)});
  const double fraction = std::pow(uniform_real(random, 0, 1), 3);
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx)
      cells.set_occupied(cx, cy, uniform_real(random, 0, 1) < fraction);
  return cells;
}

/// A point in the bounds, or up to `beyond` outside.
inline mrpt::math::TPoint2D random_point(RandomEngine& random, const Bounds& b, double beyond = 0) {
  return {uniform_real(random, b.x_min - beyond, b.x_max + beyond),
          uniform_real(random, b.y_min - beyond, b.y_max + beyond)};
}

/// A polygon with vertices at random angles and distances around a center: simple, mostly not
/// convex.
inline Polygon random_star(RandomEngine& random, const mrpt::math::TPoint2D& center, double size) {
  for (;;) {
    std::vector<double> angles(static_cast<std::size_t>(uniform_int(random, 3, 9)));
    for (double& angle : angles) angle = uniform_real(random, 0, 2 * M_PI);
    std::sort(angles.begin(), angles.end());
    if (uniform_int(random, 0, 1) == 1) std::reverse(angles.begin(), angles.end());
    Polygon polygon;
    for (const double angle : angles) {
      const double radius = uniform_real(random, 0.2, 1) * size;
      polygon.vertices.emplace_back(center.x + radius * std::cos(angle),
                                    center.y + radius * std::sin(angle));
    }
    if (is_simple(polygon)) return polygon;
  }
}

inline Primitives random_primitives(RandomEngine& random, const Bounds& bounds, int max_count) {
  Primitives obstacles;
  const double size = 0.25 * std::min(bounds.width(), bounds.height());
  for (int i = uniform_int(random, 0, max_count); i > 0; --i)
    obstacles.discs.push_back(
        {random_point(random, bounds, 0.2 * size), uniform_real(random, 0.05, 1) * size});
  for (int i = uniform_int(random, 0, max_count); i > 0; --i)
    obstacles.polygons.push_back(
        random_star(random, random_point(random, bounds, 0.2 * size), size));
  return obstacles;
}

}  // namespace slalom::testing
