#include "confined_share.h"

#include <cmath>

namespace slalom {

double fraction(double x) {
  return x - std::floor(x);
}

double confined_share(const World& world, const mrpt::math::TPoint2D& place, double range,
                      double turn) {
  constexpr double kTwoPi = 6.283185307179586476925;
  constexpr int kDirections = 64;
  constexpr double kStep = kTwoPi / kDirections;
  ScanGeometry circle;
  circle.count = kDirections;
  circle.aperture = kTwoPi - kStep;
  circle.max_range = range;
  float ranges[kDirections];
  world.ray_caster().cast_scan({place.x, place.y, turn * kStep}, circle, ranges);
  int met = 0;
  for (const float measured : ranges) met += measured < static_cast<float>(range) ? 1 : 0;
  return static_cast<double>(met) / kDirections;
}

}  // namespace slalom
