// SPDX-License-Identifier: BSD-3-Clause
#include "confined_fraction.h"

#include <cmath>

namespace slalom {

double fractional_part(double x) {
  return x - std::floor(x);
}

double confined_fraction(const World& world, const mrpt::math::TPoint2D& point, double range,
                         double turn) {
  constexpr double kTwoPi = 2 * M_PI;
  constexpr int kDirections = 64;
  constexpr double kStep = kTwoPi / kDirections;
  ScanGeometry circle;
  circle.count = kDirections;
  circle.aperture = kTwoPi - kStep;
  circle.max_range = range;
  float ranges[kDirections];
  world.ray_caster().cast_scan({point.x, point.y, turn * kStep}, circle, ranges);
  int hits = 0;
  for (const float measured : ranges) hits += measured < static_cast<float>(range) ? 1 : 0;
  return static_cast<double>(hits) / kDirections;
}

}  // namespace slalom
