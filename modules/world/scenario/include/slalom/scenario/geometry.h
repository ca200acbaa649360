// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <optional>
#include <utility>
#include <vector>

namespace slalom {

/// The workspace rectangle W (m, world frame). Everything outside it counts as occupied.
struct Bounds {
  double x_min = 0, y_min = 0, x_max = 0, y_max = 0;

  double width() const { return x_max - x_min; }
  double height() const { return y_max - y_min; }
  double area() const { return width() * height(); }
  bool contains(const mrpt::math::TPoint2D& p) const {
    return p.x >= x_min && p.x <= x_max && p.y >= y_min && p.y <= y_max;
  }
  bool operator==(const Bounds& o) const {
    return x_min == o.x_min && y_min == o.y_min && x_max == o.x_max && y_max == o.y_max;
  }
};

/// A closed disc (m).
struct Disc {
  mrpt::math::TPoint2D center;
  double radius = 0;
};

/// A closed simple polygon (m), convex or not; vertices in either order, no repeated last vertex.
struct Polygon {
  std::vector<mrpt::math::TPoint2D> vertices;
};

/// Obstacles as primitives.
struct Primitives {
  std::vector<Disc> discs;
  std::vector<Polygon> polygons;
};

double distance(const mrpt::math::TPoint2D& p, const Disc& disc);        ///< 0 inside
double distance(const mrpt::math::TPoint2D& p, const Polygon& polygon);  ///< 0 inside
bool contains(const Polygon& polygon, const mrpt::math::TPoint2D& p);    ///< border included
double distance_to_segment(const mrpt::math::TPoint2D& p, const mrpt::math::TPoint2D& a,
                           const mrpt::math::TPoint2D& b);
/// The vector to p from the nearest point of the segment.
mrpt::math::TPoint2D offset_from_segment(const mrpt::math::TPoint2D& p,
                                         const mrpt::math::TPoint2D& a,
                                         const mrpt::math::TPoint2D& b);
/// The range of f, not bounded by 0 or 1, in which |from + f movement| < radius; none if it is
/// never below.
std::optional<std::pair<double, double>> range_within(const mrpt::math::TPoint2D& from,
                                                      const mrpt::math::TPoint2D& movement,
                                                      double radius);

double signed_area(const Polygon& polygon);  ///< positive when counter-clockwise

/// Whether the polygon has at least three vertices, positive area and no two edges that cross or
/// touch (other than adjacent edges at their common vertex).
bool is_simple(const Polygon& polygon);

/// Distance along the ray from `origin` in direction `angle` to the first point of an obstacle or
/// of the border of `bounds` (from inside), at most `max_range`. 0 when the origin lies in an
/// obstacle.
double cast_ray(const Primitives& primitives, const Bounds& bounds,
                const mrpt::math::TPoint2D& origin, double angle, double max_range);

}  // namespace slalom
