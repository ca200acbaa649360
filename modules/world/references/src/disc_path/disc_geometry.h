// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/math.h>

#include <mrpt/math/TPoint2D.h>

#include <algorithm>
#include <cmath>
#include <optional>

/// The parts of the search for the shortest path of a disc. Lengths and positions are in cells.
namespace slalom::disc_path {

using Vector = mrpt::math::TPoint2D;

/// Tolerance of positions: windows are widened by it, since what they select is checked exactly.
constexpr double kPositionTolerance = 1e-7;
/// Tolerance of sines and angles (rad).
constexpr double kAngleTolerance = 1e-9;
/// A segment may be closer to an obstacle than the radius by this much, for rounding errors.
constexpr double kClearanceTolerance = 1e-11;

inline double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y;
}
inline double cross(const Vector& a, const Vector& b) {
  return a.x * b.y - a.y * b.x;
}
/// `a` rotated by 90 degrees to the left.
inline Vector left(const Vector& a) {
  return {-a.y, a.x};
}
inline double norm(const Vector& a) {
  return std::sqrt(dot(a, a));
}
inline Vector unit(double angle) {
  return {math::cos(angle), math::sin(angle)};
}

/// The angle (rad, >= 0) from a to b, turning left (+1) or right (-1); 0 if it is slightly behind.
inline double turned_angle(const Vector& a, const Vector& b, int turn) {
  return std::max(0.0, math::atan2(turn * cross(a, b), dot(a, b)));
}

/// A tangent of two circles: it leaves the first at center - turn * left(direction) * radius, and
/// arrives at the second in the same way.
struct Tangent {
  Vector direction;  ///< unit
  double length = 0;
};

/// The directed tangent that has circle a on its left if signed_radius_a > 0, on its right if it is
/// negative; likewise b. Circles that overlap by rounding errors only count as touching: compared
/// in length, not in its square, which has no accuracy there.
inline std::optional<Tangent> common_tangent(const Vector& a, double signed_radius_a,
                                             const Vector& b, double signed_radius_b) {
  constexpr double kMaxOverlap = 4e-8;
  const Vector w = b - a;
  const double square = dot(w, w), k = signed_radius_b - signed_radius_a;
  if (square == 0) return std::nullopt;
  const double rest = square - k * k;
  if (rest < 0) {
    if (std::sqrt(square) < std::abs(k) - kMaxOverlap) return std::nullopt;
    const Vector d = left(w) * (k > 0 ? -1.0 : 1.0);
    return Tangent{d * (1 / norm(d)), 0};
  }
  const double length = std::sqrt(rest);
  return Tangent{(w * length - left(w) * k) * (1 / square), length};
}

}  // namespace slalom::disc_path
