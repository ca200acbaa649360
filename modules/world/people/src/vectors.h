// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>

#include <cmath>

namespace slalom {

/// Each keeps its bits when its arguments are turned by 90 degrees, or changes only its sign when
/// they are mirrored.
inline double dot(const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b) {
  return a.x * b.x + a.y * b.y;
}

inline double cross(const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b) {
  return a.x * b.y - a.y * b.x;
}

inline mrpt::math::TPoint2D left_of(const mrpt::math::TPoint2D& a) {
  return {-a.y, a.x};
}

inline double norm(const mrpt::math::TPoint2D& a) {
  return std::sqrt(dot(a, a));
}

}  // namespace slalom
