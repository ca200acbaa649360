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

std::vector<TPoint2D> segment_ends(const Path& path, double max_length) {
  const std::size_t segments = segment_count(path, max_length);
  if (segments == 0) return {};
  return points_along(path, length(path) / static_cast<double>(segments), 0, segments + 1);
}

double fraction_below(const Path& path, double max_length, double limit,
                      const std::function<double(const TPoint2D&)>& value) {
  const std::vector<TPoint2D> ends = segment_ends(path, max_length);
  double below = 0, before = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double here = value(ends[i]) - limit;
    if (i > 0 && std::min(before, here) < 0)
      below += std::max(before, here) <= 0 ? 1 : std::min(before, here) / -std::abs(here - before);
    before = here;
  }
  return ends.size() < 2 ? 0 : below / static_cast<double>(ends.size() - 1);
}

}  // namespace slalom
