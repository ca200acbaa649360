// SPDX-License-Identifier: BSD-3-Clause
#include "sectors.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

mrpt::math::TPoint2D unit_vector(double direction) {
  return {math::cos(direction), math::sin(direction)};
}

/// Unit vectors along the rays of a scan, kept for the next scan.
const std::vector<mrpt::math::TPoint2D>& ray_directions(std::size_t count, float aperture) {
  thread_local std::vector<mrpt::math::TPoint2D> directions;
  thread_local float known_aperture = 0;
  if (directions.size() == count && known_aperture == aperture) return directions;
  directions.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const double fraction =
        count < 2 ? 0.5 : static_cast<double>(i) / static_cast<double>(count - 1);
    directions.push_back(unit_vector(aperture * (fraction - 0.5)));
  }
  known_aperture = aperture;
  return directions;
}

/// The part of `distance` in the direction u that a disc can move before it touches the point. Can
/// be negative for a disc that already touches the point.
double distance_to(const mrpt::math::TPoint2D& p, const mrpt::math::TPoint2D& u, double radius,
                   double distance) {
  const double along = p.x * u.x + p.y * u.y;
  const double lateral = p.x * u.y - p.y * u.x;
  if (along <= 0 || std::abs(lateral) >= radius) return distance;
  return std::min(distance, along - std::sqrt(radius * radius - lateral * lateral));
}

/// An upper bound of asin(x), 0 <= x <= 1, from its series: the coefficients after x sum up to
/// pi / 2 - 1.
double asin_bound(double x) {
  return x + (M_PI / 2 - 1) * x * x * x;
}

/// The direction of a point to within 0.004 rad (Rajan et al., "Efficient approximations for the
/// arctangent function", IEEE Signal Processing Magazine 23(3), 2006).
double coarse_direction(const mrpt::math::TPoint2D& p) {
  const double x = std::abs(p.x), y = std::abs(p.y);
  const double slope = std::min(x, y) / std::max(x, y);
  const double arc = slope * (M_PI / 4 + 0.273 * (1 - slope));
  const double first = y > x ? M_PI / 2 - arc : arc;
  return std::copysign(p.x < 0 ? M_PI - first : first, p.y);
}

}  // namespace

std::vector<mrpt::math::TPoint2D> obstacle_points(const mrpt::obs::CObservation2DRangeScan& scan) {
  const std::size_t count = scan.getScanSize();
  const std::vector<mrpt::math::TPoint2D>& directions = ray_directions(count, scan.aperture);
  std::vector<mrpt::math::TPoint2D> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    if (scan.getScanRangeValidity(i))
      points.push_back(directions[i] * static_cast<double>(scan.getScanRange(i)));
  return points;
}

double free_distance(const std::vector<mrpt::math::TPoint2D>& points, double direction,
                     double radius, double limit) {
  const auto u = unit_vector(direction);
  double distance = limit;
  for (const auto& p : points) distance = distance_to(p, u, radius, distance);
  return std::max(0.0, distance);
}

double sector_direction(std::size_t k, std::size_t n) {
  return M_PI * (-1 + 2 * (static_cast<double>(k) + 0.5) / static_cast<double>(n));
}

void limit_unseen(std::vector<double>& distances, double aperture, UnseenSectors unseen,
                  double limit) {
  const std::size_t count = distances.size();
  std::size_t first = 0;  // the outermost seen sector on the right; by symmetry that on the left
  while (2 * first + 1 < count && std::abs(sector_direction(first, count)) > 0.5 * aperture)
    ++first;
  const std::size_t last = count - 1 - first;
  const bool edge = unseen == UnseenSectors::Edge;
  const double other = unseen == UnseenSectors::Free ? limit : limit / 6;
  const double right = edge ? distances[first] : other, left = edge ? distances[last] : other;
  for (std::size_t k = 0; k < first; ++k) {
    distances[k] = std::min(distances[k], right);
    distances[count - 1 - k] = std::min(distances[count - 1 - k], left);
  }
}

Sectors::Sectors(std::size_t count) {
  for (std::size_t k = 0; k < count; ++k)
    directions_.push_back(unit_vector(sector_direction(k, count)));
}

/// A point is in the way in the directions within asin(radius / d) of its own, d its distance; a
/// touched one may be in any. Only these are examined, with a margin for the coarse direction.
std::vector<double> Sectors::free_distances(const std::vector<mrpt::math::TPoint2D>& points,
                                            double radius, double limit) const {
  constexpr double kAngleMargin = 0.005, kMargin = 1e-6;  // rad, m
  const auto count = static_cast<long>(directions_.size());
  const double sectors_per_radian = static_cast<double>(count) / (2 * M_PI);
  std::vector<double> distances(directions_.size(), limit);
  for (const auto& p : points) {
    const double square = p.x * p.x + p.y * p.y;
    const double reach = limit + radius + kMargin;
    if (square > reach * reach) continue;
    long first = 0, last = count - 1;
    if (const double d = std::sqrt(square); d > radius + kMargin) {
      const double bearing = coarse_direction(p);
      const double spread = asin_bound(radius / d) + kAngleMargin;
      const double center = (bearing + M_PI) * sectors_per_radian - 0.5;
      first = static_cast<long>(std::ceil(center - spread * sectors_per_radian));
      last = static_cast<long>(std::floor(center + spread * sectors_per_radian));
    }
    for (long k = first; k <= last; ++k) {
      const auto i = static_cast<std::size_t>(k < 0 ? k + count : k < count ? k : k - count);
      distances[i] = distance_to(p, directions_[i], radius, distances[i]);
    }
  }
  for (double& distance : distances) distance = std::max(0.0, distance);
  return distances;
}

}  // namespace slalom
