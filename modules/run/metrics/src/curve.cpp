// SPDX-License-Identifier: BSD-3-Clause
#include "curve.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kSpacing = 0.1;   // m, of the points whose curvature is computed
constexpr double kDense = 0.0125;  // m, of the points on the smooth curve

double norm(const TPoint2D& p) {
  return math::hypot(p.x, p.y);
}

/// The derivative by arc length at each point, of the parabola through it and its neighbors.
std::vector<TPoint2D> tangents(const Path& path) {
  const std::size_t last = path.size() - 1;
  std::vector<TPoint2D> slopes(last), result(path.size());
  for (std::size_t i = 0; i < last; ++i)
    slopes[i] = (path[i + 1] - path[i]) * (1 / norm(path[i + 1] - path[i]));
  for (std::size_t i = 1; i < last; ++i) {
    const double before = norm(path[i] - path[i - 1]), after = norm(path[i + 1] - path[i]);
    result[i] = (slopes[i - 1] * after + slopes[i] * before) * (1 / (before + after));
  }
  result[0] = last > 1 ? slopes[0] * 2.0 - result[1] : slopes[0];
  result[last] = last > 1 ? slopes[last - 1] * 2.0 - result[last - 1] : slopes[0];
  return result;
}

/// Points on a cubic Hermite spline through the path's points.
Path smooth(const Path& path) {
  const std::vector<TPoint2D> slopes = tangents(path);
  Path points = {path[0]};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double chord = norm(path[i] - path[i - 1]);
    const double pieces = std::ceil(chord / kDense);
    for (double k = 1; k <= pieces; ++k) {
      const double t = k / pieces, u = 1 - t;
      points.push_back(path[i - 1] * ((1 + 2 * t) * u * u) + path[i] * (t * t * (3 - 2 * t)) +
                       (slopes[i - 1] * (t * u * u) - slopes[i] * (t * t * u)) * chord);
    }
  }
  return points;
}

/// Points at arc lengths of multiples of `spacing`; the remainder at the end is omitted.
Path at_equal_lengths(const Path& path, double spacing) {
  Path points = {path[0]};
  double to_next = spacing;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double piece = norm(path[i] - path[i - 1]);
    double at = to_next;
    for (; at <= piece; at += spacing)
      points.push_back(path[i - 1] + (path[i] - path[i - 1]) * (at / piece));
    to_next = at - piece;
  }
  return points;
}

double menger(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c) {
  const TPoint2D ab = b - a, bc = c - b;
  const double across = norm(c - a), turn = std::abs(ab.x * bc.y - ab.y * bc.x);
  // Reversal: the limit of the circle's curvature.
  if (across < 1e-6) return 4 / (norm(ab) + norm(bc));
  return 2 * turn / (norm(ab) * norm(bc) * across);
}

}  // namespace

Path without_close_points(const Path& path) {
  constexpr double kClose = 1e-3;  // m
  Path kept;
  for (const TPoint2D& p : path)
    if (kept.empty() || norm(p - kept.back()) >= kClose) kept.push_back(p);
  return kept;
}

double rotation(const Path& path) {
  const Path points = without_close_points(path);
  double sum = 0;
  for (std::size_t i = 2; i < points.size(); ++i) {
    const TPoint2D before = points[i - 1] - points[i - 2], after = points[i] - points[i - 1];
    sum += std::abs(math::atan2(before.x * after.y - before.y * after.x,
                                before.x * after.x + before.y * after.y));
  }
  return sum;
}

std::vector<double> curvatures(const Path& path) {
  const Path kept = without_close_points(path);
  std::vector<double> values;
  if (kept.size() < 2) return values;
  const Path points = at_equal_lengths(smooth(kept), kSpacing);
  for (std::size_t i = 2; i < points.size(); ++i)
    values.push_back(menger(points[i - 2], points[i - 1], points[i]));
  return values;
}

}  // namespace slalom
