// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace slalom {

/// The point of the segment from a to b that is nearest to p. Its distance to p may differ in the
/// last bits from offset_from_segment(), which subtracts in another order.
inline mrpt::math::TPoint2D nearest_on_segment(const mrpt::math::TPoint2D& p,
                                               const mrpt::math::TPoint2D& a,
                                               const mrpt::math::TPoint2D& b) {
  const mrpt::math::TPoint2D edge = b - a, to_p = p - a;
  const double length2 = edge.x * edge.x + edge.y * edge.y;
  if (length2 <= 0) return a;
  return a + edge * std::clamp((to_p.x * edge.x + to_p.y * edge.y) / length2, 0.0, 1.0);
}

inline bool is_finite(const mrpt::math::TPoint2D& p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

/// The points p with normal * p >= bound.
struct HalfPlane {
  mrpt::math::TVector2D normal;
  double bound = 0;

  /// How far p is beyond the bound, in lengths of the normal; negative outside.
  double excess(const mrpt::math::TPoint2D& p) const {
    return normal.x * p.x + normal.y * p.y - bound;
  }
};

/// The part of a convex polygon in a half plane: its corners in the same order, none if it is
/// empty. Polygons may be degenerate, down to a point.
std::vector<mrpt::math::TPoint2D> clipped(const std::vector<mrpt::math::TPoint2D>& polygon,
                                          const HalfPlane& half_plane);

/// The point of the polygon's border that is nearest to p. Requires a corner.
mrpt::math::TPoint2D nearest_on_border(const mrpt::math::TPoint2D& p,
                                       const std::vector<mrpt::math::TPoint2D>& polygon);

}  // namespace slalom
