// SPDX-License-Identifier: BSD-3-Clause
#include "along_path.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Number of equal segments of at most `max_length`.
std::size_t segment_count(const Path& path, double max_length) {
  constexpr double kMaxSegments = 100000;
  const double path_length = length(path);
  if (!(path_length > 0)) return 0;
  return static_cast<std::size_t>(
      std::clamp(std::ceil(path_length / max_length), 1.0, kMaxSegments));
}

/// `count` points at distances (first + k) `step` (m) from the start of the path, k = 0, 1, ...
std::vector<TPoint2D> points_along(const Path& path, double step, double first, std::size_t count) {
  std::vector<TPoint2D> points;
  double passed = 0;  // length up to the previous vertex
  for (std::size_t i = 1; i < path.size(); ++i) {
    const TPoint2D leg = path[i] - path[i - 1];
    const double leg_length = leg.norm();
    while (leg_length > 0 && points.size() < count) {
      const double on = step * (first + static_cast<double>(points.size())) - passed;
      if (on > leg_length) break;
      points.push_back(path[i - 1] + leg * (on / leg_length));
    }
    passed += leg_length;
  }
  while (points.size() < count) points.push_back(path.back());  // rounding
  return points;
}

}  // namespace

std::vector<TPoint2D> segment_midpoints(const Path& path, double max_length) {
  const std::size_t segments = segment_count(path, max_length);
  return points_along(path, length(path) / static_cast<double>(segments), 0.5, segments);
}

double fraction_below(const Path& path, double max_length, double limit,
                      const std::function<double(const TPoint2D&)>& value) {
  constexpr double kRounding = 1e-6;  // segments
  const std::size_t segments = segment_count(path, max_length);
  if (segments == 0) return 0;
  const double step = length(path) / static_cast<double>(segments);
  const std::vector<TPoint2D> ends = points_along(path, step, 0, segments + 1);
  double below = 0, before = value(ends[0]) - limit;
  for (std::size_t i = 0; i < segments;) {
    // So many segments, at least one, on which the value stays on the same side of the limit.
    const auto same = static_cast<std::size_t>(
        std::clamp(std::abs(before) / step - kRounding, 1.0, static_cast<double>(segments - i)));
    i += same;
    const double here = value(ends[i]) - limit;
    if (std::min(before, here) < 0)
      below += std::max(before, here) <= 0 ? static_cast<double>(same)
                                           : std::min(before, here) / -std::abs(here - before);
    before = here;
  }
  return below / static_cast<double>(segments);
}

}  // namespace slalom
