// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/geometry.h>

#include <cstddef>

namespace slalom {

using mrpt::math::TPoint2D;

std::vector<TPoint2D> clipped(const std::vector<TPoint2D>& polygon, const HalfPlane& half_plane) {
  constexpr double kTolerance = 1e-12;  // so that a corner on the border stays
  std::vector<TPoint2D> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const TPoint2D &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = half_plane.excess(a), at_b = half_plane.excess(b);
    if (at_a >= -kTolerance) result.push_back(a);
    if ((at_a > kTolerance && at_b < -kTolerance) || (at_a < -kTolerance && at_b > kTolerance))
      result.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return result;
}

TPoint2D nearest_on_border(const TPoint2D& p, const std::vector<TPoint2D>& polygon) {
  TPoint2D nearest = polygon.front();
  double least = (nearest - p).sqrNorm();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const TPoint2D q = nearest_on_segment(p, polygon[i], polygon[(i + 1) % polygon.size()]);
    const double distance2 = (q - p).sqrNorm();
    if (distance2 >= least) continue;
    least = distance2;
    nearest = q;
  }
  return nearest;
}

}  // namespace slalom
