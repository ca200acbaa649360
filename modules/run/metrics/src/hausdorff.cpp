// SPDX-License-Identifier: BSD-3-Clause
#include "path_distance.h"
#include "path_similarity.h"

#include <algorithm>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kTolerance = 1e-6;  // m

/// A point with its distance to the other path and the nearest segment of that path.
struct Measured {
  TPoint2D at;
  double distance;
  std::size_t piece;
};

Measured measure(const TPoint2D& p, PathDistance& to) {
  const double distance = to(p);
  return {p, distance, to.nearest_piece()};
}

/// An upper bound of the distance along the segment from a to b: the distance to any one segment of
/// the other path is convex along it.
double upper_bound(const Measured& a, const Measured& b, const PathDistance& to) {
  return std::min(std::max(a.distance, to.distance_to_piece(b.at, a.piece)),
                  std::max(b.distance, to.distance_to_piece(a.at, b.piece)));
}

/// Directed Hausdorff distance from `from` to `other`: branch and bound over the segments of
/// `from`.
double directed(const Path& from, const Path& other) {
  PathDistance to(other);
  std::vector<Measured> vertices;
  double farthest = 0;
  for (const TPoint2D& p : from) {
    vertices.push_back(measure(p, to));
    farthest = std::max(farthest, vertices.back().distance);
  }
  std::vector<std::pair<Measured, Measured>> open;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    open.emplace_back(vertices[i - 1], vertices[i]);
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      if (upper_bound(a, b, to) <= farthest + kTolerance) continue;
      const Measured middle = measure((a.at + b.at) * 0.5, to);
      farthest = std::max(farthest, middle.distance);
      open.emplace_back(middle, b);
      open.emplace_back(a, middle);
    }
  }
  return farthest;
}

}  // namespace

double hausdorff_distance(const Path& a, const Path& b) {
  return std::max(directed(a, b), directed(b, a));
}

}  // namespace slalom
