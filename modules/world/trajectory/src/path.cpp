// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/geometry.h>
#include <slalom/core/math.h>
#include <slalom/trajectory/path.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace slalom {

using mrpt::math::TPoint2D;

double length(const Path& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += distance_between(path[i], path[i - 1]);
  return sum;
}

double distance_to_path(const TPoint2D& p, const Path& path) {
  if (path.empty()) throw std::invalid_argument("distance_to_path: the path is empty");
  double best = distance_between(p, path[0]);
  for (std::size_t i = 1; i < path.size(); ++i)
    best = std::min(best, distance_between(p, nearest_on_segment(p, path[i - 1], path[i])));
  return best;
}

Path resample(const Path& path, double spacing) {
  if (!(spacing > 0)) throw std::invalid_argument("resample: the spacing must be positive");
  Path result;
  if (path.empty()) return result;
  result.push_back(path.front());
  for (std::size_t i = 1; i < path.size(); ++i) {
    const TPoint2D step = path[i] - path[i - 1];
    const double pieces = std::max(1.0, std::ceil(math::hypot(step.x, step.y) / spacing));
    for (double k = 1; k < pieces; ++k) result.push_back(path[i - 1] + step * (k / pieces));
    result.push_back(path[i]);
  }
  return result;
}

}  // namespace slalom
