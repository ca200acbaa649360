#include "along_path.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Number of equal pieces, none longer than `longest`.
std::size_t pieces_of(const Path& path, double longest) {
  constexpr double kMostPieces = 100000;
  const double metres = length(path);
  if (!(metres > 0)) return 0;
  return static_cast<std::size_t>(std::clamp(std::ceil(metres / longest), 1.0, kMostPieces));
}

/// Points at `first`, `first` + 1, ... steps (of `step` metres) from the start of the path.
std::vector<TPoint2D> points_along(const Path& path, double step, double first, std::size_t count) {
  std::vector<TPoint2D> points;
  double passed = 0;  // up to the corner behind
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

std::vector<TPoint2D> piece_middles(const Path& path, double longest) {
  const std::size_t pieces = pieces_of(path, longest);
  return points_along(path, length(path) / static_cast<double>(pieces), 0.5, pieces);
}

std::vector<TPoint2D> piece_ends(const Path& path, double longest) {
  const std::size_t pieces = pieces_of(path, longest);
  if (pieces == 0) return {};
  return points_along(path, length(path) / static_cast<double>(pieces), 0, pieces + 1);
}

double share_below(const Path& path, double longest, double limit,
                   const std::function<double(const TPoint2D&)>& value) {
  const std::vector<TPoint2D> ends = piece_ends(path, longest);
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
