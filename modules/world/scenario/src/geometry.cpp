// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/scenario/geometry.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

double cross(const TPoint2D& a, const TPoint2D& b) {
  return a.x * b.y - a.y * b.x;
}
double dot(const TPoint2D& a, const TPoint2D& b) {
  return a.x * b.x + a.y * b.y;
}

/// Twice the signed area of the triangle a, b, c.
double orientation(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c) {
  return cross(b - a, c - a);
}

/// Whether p, on the line through a and b, lies between them.
bool between(const TPoint2D& a, const TPoint2D& b, const TPoint2D& p) {
  return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
         p.y <= std::max(a.y, b.y);
}

/// Whether two closed segments have a point in common.
bool segments_touch(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c, const TPoint2D& d) {
  const double abc = orientation(a, b, c), abd = orientation(a, b, d);
  const double cda = orientation(c, d, a), cdb = orientation(c, d, b);
  if (((abc > 0 && abd < 0) || (abc < 0 && abd > 0)) &&
      ((cda > 0 && cdb < 0) || (cda < 0 && cdb > 0)))
    return true;
  return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) ||
         (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
}

/// Whether the corner a, b, c reverses direction (or an edge has no length).
bool folds_back(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c) {
  return a == b || (orientation(a, b, c) == 0 && dot(b - a, c - b) < 0);
}

/// Whether two non-adjacent edges touch. Sweeps edges from left to right; compares only those that
/// overlap in x.
bool edges_touch(const std::vector<TPoint2D>& v) {
  const std::size_t n = v.size();
  const auto left = [&](std::size_t i) { return std::min(v[i].x, v[(i + 1) % n].x); };
  const auto right = [&](std::size_t i) { return std::max(v[i].x, v[(i + 1) % n].x); };
  std::vector<std::size_t> order(n), active;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return left(a) != left(b) ? left(a) < left(b) : a < b;
  });
  for (const std::size_t i : order) {
    const double x = left(i);
    active.erase(
        std::remove_if(active.begin(), active.end(), [&](std::size_t k) { return right(k) < x; }),
        active.end());
    for (const std::size_t k : active) {
      const bool adjacent = (i + 1) % n == k || (k + 1) % n == i;
      if (!adjacent && segments_touch(v[i], v[(i + 1) % n], v[k], v[(k + 1) % n])) return true;
    }
    active.push_back(i);
  }
  return false;
}

constexpr double kMiss = std::numeric_limits<double>::infinity();

double cast_on_disc(const Disc& disc, const TPoint2D& origin, const TPoint2D& direction) {
  const TPoint2D from_center = origin - disc.center;
  const double outside = dot(from_center, from_center) - disc.radius * disc.radius;
  if (outside <= 0) return 0;
  const double approach = -dot(from_center, direction);
  const double offset = cross(from_center, direction);
  const double discriminant = disc.radius * disc.radius - offset * offset;
  if (approach < 0 || discriminant < 0) return kMiss;
  return outside / (approach + std::sqrt(discriminant));
}

/// The offset of each end from the ray decides whether the segment is crossed. Edges with a common
/// end use the same offset, so that no ray passes between them.
double cast_on_segment(const TPoint2D& a, const TPoint2D& b, const TPoint2D& direction) {
  const double offset_a = cross(direction, a), offset_b = cross(direction, b);
  if ((offset_a > 0 && offset_b > 0) || (offset_a < 0 && offset_b < 0)) return kMiss;
  const double along_a = dot(direction, a), along_b = dot(direction, b);
  if (offset_a == offset_b) {  // the segment lies on the ray's line
    const double nearest = std::min(along_a, along_b);
    return nearest >= 0 ? nearest : kMiss;
  }
  const double t = (along_a * offset_b - along_b * offset_a) / (offset_b - offset_a);
  return t >= 0 ? t : kMiss;
}

double cast_on_polygon(const Polygon& polygon, const TPoint2D& origin, const TPoint2D& direction) {
  if (contains(polygon, origin)) return 0;
  double nearest = kMiss;
  const auto& v = polygon.vertices;
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++)
    nearest = std::min(nearest, cast_on_segment(v[j] - origin, v[i] - origin, direction));
  return nearest;
}

double cast_on_bounds(const Bounds& bounds, const TPoint2D& origin, const TPoint2D& direction) {
  const bool within = origin.x > bounds.x_min && origin.x < bounds.x_max &&
                      origin.y > bounds.y_min && origin.y < bounds.y_max;
  if (!within) return 0;
  double nearest = kMiss;
  if (direction.x > 0) nearest = std::min(nearest, (bounds.x_max - origin.x) / direction.x);
  if (direction.x < 0) nearest = std::min(nearest, (bounds.x_min - origin.x) / direction.x);
  if (direction.y > 0) nearest = std::min(nearest, (bounds.y_max - origin.y) / direction.y);
  if (direction.y < 0) nearest = std::min(nearest, (bounds.y_min - origin.y) / direction.y);
  return nearest;
}

}  // namespace

TPoint2D offset_from_segment(const TPoint2D& p, const TPoint2D& a, const TPoint2D& b) {
  const TPoint2D edge = b - a, to_p = p - a;
  const double length2 = dot(edge, edge);
  const double fraction = length2 > 0 ? std::clamp(dot(to_p, edge) / length2, 0.0, 1.0) : 0.0;
  return {to_p.x - fraction * edge.x, to_p.y - fraction * edge.y};
}

double distance_to_segment(const TPoint2D& p, const TPoint2D& a, const TPoint2D& b) {
  const TPoint2D offset = offset_from_segment(p, a, b);
  return math::hypot(offset.x, offset.y);
}

double distance(const TPoint2D& p, const Disc& disc) {
  return std::max(0.0, distance_between(p, disc.center) - disc.radius);
}

double distance(const TPoint2D& p, const Polygon& polygon) {
  if (contains(polygon, p)) return 0;
  double nearest = kMiss;
  const auto& v = polygon.vertices;
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++)
    nearest = std::min(nearest, distance_to_segment(p, v[j], v[i]));
  return nearest;
}

bool contains(const Polygon& polygon, const TPoint2D& p) {
  bool inside = false;
  const auto& v = polygon.vertices;
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
    const double side = orientation(v[j], v[i], p);
    if (side == 0 && between(v[j], v[i], p)) return true;
    const bool upwards = v[i].y > v[j].y;
    if ((v[i].y > p.y) != (v[j].y > p.y) && (upwards ? side > 0 : side < 0)) inside = !inside;
  }
  return inside;
}

std::optional<std::pair<double, double>> range_within(const TPoint2D& from,
                                                      const TPoint2D& movement, double radius) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double distance = math::hypot(from.x, from.y);
  const double a = movement.x * movement.x + movement.y * movement.y;
  const double b = from.x * movement.x + from.y * movement.y;
  // A product: the difference of squares would lose the digits of a small gap.
  const double c = (distance - radius) * (distance + radius);
  if (a <= 0) return c < 0 ? std::optional(std::pair(-kInfinity, kInfinity)) : std::nullopt;
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0)) return std::nullopt;
  // The root of the larger magnitude first: the other one then without cancellation.
  const double q = -b - std::copysign(std::sqrt(discriminant), b);
  return std::minmax({q / a, c / q});
}

double signed_area(const Polygon& polygon) {
  const auto& v = polygon.vertices;
  double twice = 0;
  for (std::size_t i = 2; i < v.size(); ++i) twice += orientation(v[0], v[i - 1], v[i]);
  return 0.5 * twice;
}

bool is_simple(const Polygon& polygon) {
  const auto& v = polygon.vertices;
  const std::size_t n = v.size();
  if (n < 3 || !(std::abs(signed_area(polygon)) > 0)) return false;
  for (std::size_t i = 0; i < n; ++i)
    if (folds_back(v[i], v[(i + 1) % n], v[(i + 2) % n])) return false;
  return !edges_touch(v);
}

double cast_ray(const Primitives& primitives, const Bounds& bounds, const TPoint2D& origin,
                double angle, double max_range) {
  const TPoint2D direction(math::cos(angle), math::sin(angle));
  double nearest = std::min(max_range, cast_on_bounds(bounds, origin, direction));
  for (const Disc& disc : primitives.discs)
    nearest = std::min(nearest, cast_on_disc(disc, origin, direction));
  for (const Polygon& polygon : primitives.polygons)
    nearest = std::min(nearest, cast_on_polygon(polygon, origin, direction));
  return nearest;
}

}  // namespace slalom
