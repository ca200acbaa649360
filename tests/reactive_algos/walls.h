// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "follow_the_gap.h"

#include <cmath>
#include <utility>
#include <vector>

namespace follow_the_gap {

/// A straight wall between two points (m, robot frame: x ahead, y left).
struct Wall {
  double x1, y1, x2, y2;
};

/// Distance along the ray of `angle` to the wall, or `max_range`.
inline double range_to(const Wall& wall, double angle, double max_range) {
  const double dx = std::cos(angle), dy = std::sin(angle);
  const double ex = wall.x2 - wall.x1, ey = wall.y2 - wall.y1;
  const double crossed = dx * ey - dy * ex;
  if (crossed == 0) return max_range;
  const double range = (wall.x1 * ey - wall.y1 * ex) / crossed;
  const double along = (wall.x1 * dy - wall.y1 * dx) / crossed;
  return range > 0 && along >= 0 && along <= 1 ? std::min(range, max_range) : max_range;
}

/// A scan of 181 rays over 180 degrees, with a range of 8 m.
inline std::vector<double> scan_of(const std::vector<Wall>& walls) {
  constexpr std::size_t kRays = 181;
  std::vector<double> ranges(kRays, 8.0);
  for (std::size_t i = 0; i < kRays; ++i)
    for (const Wall& wall : walls)
      ranges[i] = std::min(ranges[i], range_to(wall, ray_angle(i, kRays, M_PI), 8.0));
  return ranges;
}

/// A wall across the path, `distance` ahead, with an opening between two y coordinates.
inline std::vector<Wall> wall_with_opening(double distance, double low, double high) {
  return {{distance, -20, distance, low}, {distance, high, distance, 20}};
}

}  // namespace follow_the_gap
