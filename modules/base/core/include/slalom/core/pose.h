// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/math.h>

#include <mrpt/math/TPose2D.h>
#include <mrpt/math/wrap2pi.h>

namespace slalom {

// Instead of TPose2D's functions, whose last bits depend on MRPT's package: that for ARM rounds a
// product and a sum at once.

/// The point with the coordinates `local` in the frame of `pose`.
inline mrpt::math::TPoint2D compose(const mrpt::math::TPose2D& pose,
                                    const mrpt::math::TPoint2D& local) {
  const auto [s, c] = math::sin_cos(pose.phi);
  return {pose.x + local.x * c - local.y * s, pose.y + local.x * s + local.y * c};
}

/// The coordinates of `point` in the frame of `pose`.
inline mrpt::math::TPoint2D inverse_compose(const mrpt::math::TPose2D& pose,
                                            const mrpt::math::TPoint2D& point) {
  const auto [s, c] = math::sin_cos(pose.phi);
  const double dx = point.x - pose.x, dy = point.y - pose.y;
  return {dx * c + dy * s, -dx * s + dy * c};
}

/// The pose at `fraction` from `from` to `to`: the position and the heading change linearly.
inline mrpt::math::TPose2D interpolate(const mrpt::math::TPose2D& from,
                                       const mrpt::math::TPose2D& to, double fraction) {
  const double turn = mrpt::math::wrapToPi(to.phi - from.phi);
  return {from.x + fraction * (to.x - from.x), from.y + fraction * (to.y - from.y),
          mrpt::math::wrapToPi(from.phi + fraction * turn)};
}

}  // namespace slalom
