// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>

#include <vector>

namespace slalom {

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
