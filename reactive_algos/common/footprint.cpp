// SPDX-License-Identifier: BSD-3-Clause
#include "common/footprint.h"

#include <algorithm>

namespace reactive {
namespace {

using Polygon = std::vector<Point>;  // convex, counter-clockwise

Point between(const Point& a, const Point& b, double fraction) {
  return {a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y)};
}

/// The points of a polygon that are at least `depth` m from its border; empty if there are none.
Polygon inset(const Polygon& polygon, double depth) {
  Polygon result = polygon;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const auto beyond = [&](const Point& p) {
      return ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / distance(a, b) - depth;
    };
    Polygon clipped;
    for (std::size_t k = 0; k < result.size(); ++k) {
      const Point &p = result[k], &q = result[(k + 1) % result.size()];
      const double from = beyond(p), to = beyond(q);
      if (from >= 0) clipped.push_back(p);
      if ((from < 0) != (to < 0)) clipped.push_back(between(p, q, from / (from - to)));
    }
    result = clipped;
  }
  return result;
}

/// Radius of the largest disc in a polygon, m.
double inradius(const Polygon& polygon) {
  double low = 0, high = distance(polygon[0], polygon[1]);
  for (const Point& p : polygon) high = std::max(high, distance(p, polygon[0]));
  while (high - low > 1e-6) {
    const double middle = 0.5 * (low + high);
    (inset(polygon, middle).empty() ? high : low) = middle;
  }
  return low;
}

/// Points along the border, at most `spacing` m apart, corners included.
std::vector<Point> along_border(const Polygon& polygon, double spacing) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double count = std::max(1.0, std::ceil(distance(a, b) / spacing - 1e-6));
    for (int k = 0; k < count; ++k) points.push_back(between(a, b, k / count));
  }
  return points;
}

/// The maximum distance of a point of `points` from the closest one of `centers`.
double farthest(const std::vector<Point>& points, const std::vector<Point>& centers) {
  double result = 0;
  for (const Point& p : points) {
    double nearest = HUGE_VAL;
    for (const Point& center : centers) nearest = std::min(nearest, distance(p, center));
    result = std::max(result, nearest);
  }
  return result;
}

}  // namespace

/// One row of discs covers the border: their centers are at a third of the inradius from it, twice
/// that apart. Others cover what remains around the longest line in the middle.
Robot with_cover_discs(Robot robot) {
  const Polygon& corners = robot.footprint;
  if (corners.empty()) return robot;
  const double max_depth = inradius(corners), depth = max_depth / 3;
  const std::vector<Point> ring = along_border(inset(corners, depth), 2 * depth);
  const double spacing = 0.05 * depth;  // of the points of the border that are examined
  const double excess = farthest(along_border(corners, spacing), ring) + spacing - depth;
  robot.radius = max_depth + excess;
  robot.discs.clear();
  for (const Point& center : ring) robot.discs.push_back({center, max_depth - depth});
  constexpr double kMiddle = 0.99;  // of the inradius: there the polygon is hardly more than a line
  const Polygon middle = inset(corners, kMiddle * max_depth);
  Point a, b;
  for (const Point& p : middle)
    for (const Point& q : middle)
      if (distance(p, q) >= distance(a, b)) {
        a = p;
        b = q;
      }
  const int count = std::max(1, static_cast<int>(std::ceil(distance(a, b) / max_depth)));
  for (int i = 0; i < count; ++i)
    robot.discs.push_back({between(a, b, (i + 0.5) / count), (1 - kMiddle) * max_depth});
  return robot;
}

double footprint_clearance(const ClearanceMap& map, const Pose& pose, const Robot& robot) {
  const Transform frame(pose);
  double result = HUGE_VAL;
  for (const FootprintDisc& disc : robot.discs)
    result = std::min(result, map.at(frame.to_world(disc.center)) + disc.inset);
  return result;
}

void footprint_clearances(const ClearanceMap& map, const PoseBatch& poses, std::size_t count,
                          const Robot& robot, double* clearances) {
  if (robot.is_disc()) {
    map.at(poses.x.data(), poses.y.data(), count, clearances);
    return;
  }
  std::vector<double> x(padded(count)), y(padded(count)), values(padded(count));
  std::fill_n(clearances, count, HUGE_VAL);
  for (const FootprintDisc& disc : robot.discs) {
    const Point& p = disc.center;
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = poses.x[i] + p.x * poses.cosine[i] - p.y * poses.sine[i];
      y[i] = poses.y[i] + p.x * poses.sine[i] + p.y * poses.cosine[i];
    }
    map.at(x.data(), y.data(), count, values.data());
    for (std::size_t i = 0; i < count; ++i)
      clearances[i] = std::min(clearances[i], values[i] + disc.inset);
  }
}

double free_rotation(const ClearanceMap& map, const Pose& pose, const Robot& robot, double radius,
                     int side, double limit) {
  constexpr double kMinStep = 0.02;    // m, of the farthest center
  constexpr double kMinMargin = 0.02;  // m beyond the radius: errors of the map beside small discs
  if (robot.is_disc()) return limit;
  const double reach = robot.reach(), here = footprint_clearance(map, pose, robot);
  const double needed = std::max(radius, std::min(robot.radius + kMinMargin, here));
  double angle = 0, free = 0;
  while (true) {
    const Pose turned = {pose.x, pose.y, pose.phi + side * angle};
    const double gap = footprint_clearance(map, turned, robot) - needed;
    if (gap < 0) return free;
    if (angle == limit) return limit;
    free = angle;
    // Contact is not possible before the farthest center has moved by the gap.
    angle = std::min(limit, angle + std::max(gap, kMinStep) / reach);
  }
}

bool can_rotate(const ClearanceMap& map, const Pose& pose, const Robot& robot, double radius,
                double w, double period) {
  const double angle = std::abs(w) * period + w * w / (2 * kBrakingFraction * robot.max_accel_w);
  return free_rotation(map, pose, robot, radius, w < 0 ? -1 : 1, angle) >= angle;
}

}  // namespace reactive
