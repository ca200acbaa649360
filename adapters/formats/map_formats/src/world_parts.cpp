// SPDX-License-Identifier: BSD-3-Clause
#include "world_parts.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/scenario/grid_map.h>
#include <slalom/scenario/occupancy.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;

constexpr double kFarthest = 1e6;  ///< m
constexpr double kUpright = 1e-6;  ///< of the cosine of the tilt
constexpr std::size_t kMaxSolids = 200'000;
constexpr std::size_t kMaxNames = 8;  ///< of a kind, in a message
constexpr int kCorners = 32;          ///< of a tilted cylinder

bool is_upright(const Placement& pose) {
  return std::abs(pose.cosine_of_tilt()) > 1 - kUpright;
}

TPoint3D placed(const Placement& pose, double x, double y, double z) {
  return pose.point({x, y, z});
}

/// Twice the area of the triangle, positive when counter-clockwise.
double turn(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The convex hull, counter-clockwise without collinear corners (Andrew's monotone chain).
Polygon convex_hull(std::vector<TPoint2D> points) {
  std::sort(points.begin(), points.end(), [](const TPoint2D& a, const TPoint2D& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
  Polygon hull;
  auto& corners = hull.vertices;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = corners.size();
    for (const TPoint2D& point : points) {
      while (corners.size() >= begin + 2 &&
             turn(corners[corners.size() - 2], corners.back(), point) <= 0)
        corners.pop_back();
      corners.push_back(point);
    }
    if (!corners.empty()) corners.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

bool is_convex(const Polygon& polygon) {
  const auto& corners = polygon.vertices;
  bool left = false, right = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double area =
        turn(corners[i], corners[(i + 1) % corners.size()], corners[(i + 2) % corners.size()]);
    left = left || area > 0;
    right = right || area < 0;
  }
  return !(left && right);
}

/// The points of an edge at both ends of a range of heights, and its ends within.
void add_clipped(const TPoint3D& a, const TPoint3D& b, double low, double high,
                 std::vector<TPoint2D>& points) {
  for (const TPoint3D& end : {a, b})
    if (end.z >= low && end.z <= high) points.emplace_back(end.x, end.y);
  for (const double z : {low, high}) {
    if ((a.z < z) == (b.z < z)) continue;
    const double f = (z - a.z) / (b.z - a.z);
    points.emplace_back(a.x + f * (b.x - a.x), a.y + f * (b.y - a.y));
  }
}

/// A regular polygon around a disc.
Polygon around_disc(double radius) {
  Polygon polygon;
  const double corner = radius / math::cos(M_PI / kCorners);
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * M_PI * i / kCorners;
    polygon.vertices.emplace_back(corner * math::cos(angle), corner * math::sin(angle));
  }
  return polygon;
}

}  // namespace

WorldParts::WorldParts(std::string where, const WorldOptions& options)
    : where_(std::move(where)), options_(options) {
  if (!(options.margin > 0) || !std::isfinite(options.margin))
    throw usage_error(where_, "invalid margin " + format_number(options.margin) + " m",
                      "a length > 0");
}

void WorldParts::count(std::size_t& counter, std::size_t limit, const std::string& what) const {
  if (++counter > limit)
    throw file_error(where_, "has more than " + std::to_string(limit) + " " + what,
                     "a smaller world");
}

bool WorldParts::in_heights(double low, double high) {
  count(solids_, kMaxSolids, "collision shapes");
  const bool inside = high > options_.z_min && low < options_.z_max;
  if (!inside) ++outside_heights_;
  return inside;
}

void WorldParts::add_disc(const TPoint2D& center, double radius) {
  if (!(std::abs(center.x) + radius <= kFarthest) || !(std::abs(center.y) + radius <= kFarthest))
    throw file_error(where_, "has an obstacle beyond 1000 km", "coordinates in m");
  obstacles_.discs.push_back({center, radius});
}

void WorldParts::add_polygon(Polygon polygon) {
  for (const TPoint2D& corner : polygon.vertices)
    if (!(std::abs(corner.x) <= kFarthest) || !(std::abs(corner.y) <= kFarthest))
      throw file_error(where_, "has an obstacle beyond 1000 km", "coordinates in m");
  if (is_simple(polygon)) obstacles_.polygons.push_back(std::move(polygon));
}

bool WorldParts::add_prism(const Placement& pose, const Polygon& outline, double z_low,
                           double z_high) {
  const bool upright = is_upright(pose);
  if (!upright && !is_convex(outline)) return false;
  std::vector<TPoint3D> below, above;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const TPoint2D& corner : outline.vertices) {
    below.push_back(placed(pose, corner.x, corner.y, z_low));
    above.push_back(placed(pose, corner.x, corner.y, z_high));
    low = std::min({low, below.back().z, above.back().z});
    high = std::max({high, below.back().z, above.back().z});
  }
  if (!in_heights(low, high)) return true;
  std::vector<TPoint2D> points;
  for (std::size_t i = 0; i < below.size(); ++i) {
    if (upright) {
      points.emplace_back(below[i].x, below[i].y);
      continue;
    }
    const std::size_t next = (i + 1) % below.size();
    add_clipped(below[i], above[i], options_.z_min, options_.z_max, points);
    add_clipped(below[i], below[next], options_.z_min, options_.z_max, points);
    add_clipped(above[i], above[next], options_.z_min, options_.z_max, points);
  }
  add_polygon(upright ? Polygon{points} : convex_hull(points));
  return true;
}

void WorldParts::add_box(const Placement& pose, double x, double y, double z) {
  const Polygon outline{{{-x / 2, -y / 2}, {x / 2, -y / 2}, {x / 2, y / 2}, {-x / 2, y / 2}}};
  add_prism(pose, outline, -z / 2, z / 2);
}

void WorldParts::add_cylinder(const Placement& pose, double radius, double length) {
  if (!is_upright(pose)) {
    add_prism(pose, around_disc(radius), -length / 2, length / 2);
  } else if (in_heights(pose.z() - length / 2, pose.z() + length / 2)) {
    add_disc({pose.x(), pose.y()}, radius);
  }
}

void WorldParts::add_sphere(const Placement& pose, double radius) {
  if (!in_heights(pose.z() - radius, pose.z() + radius)) return;
  const double height = std::clamp(pose.z(), options_.z_min, options_.z_max) - pose.z();
  const double widest = std::sqrt(std::max(0.0, (radius - height) * (radius + height)));
  if (widest > 0) add_disc({pose.x(), pose.y()}, widest);
}

void WorldParts::leave_out(const std::string& kind, const std::string& name) {
  auto of_kind = std::find_if(left_out_.begin(), left_out_.end(),
                              [&](const auto& entry) { return entry.first == kind; });
  if (of_kind == left_out_.end()) of_kind = left_out_.insert(left_out_.end(), {kind, {}});
  auto& names = of_kind->second;
  if (names.empty() || names.back().first != name.substr(0, 100))
    names.emplace_back(name.substr(0, 100), 0);
  ++names.back().second;
}

std::string WorldParts::left_out_text() const {
  std::vector<std::string> parts;
  for (const auto& [kind, names] : left_out_) {
    std::string part = kind;
    for (std::size_t i = 0; i < std::min(names.size(), kMaxNames); ++i)
      part += (i > 0 ? ", " : " ") +
              (names[i].first.empty() ? "without a name" : "'" + names[i].first + "'") +
              (names[i].second > 1 ? " (" + std::to_string(names[i].second) + ")" : "");
    if (names.size() > kMaxNames)
      part += " and " + std::to_string(names.size() - kMaxNames) + " more";
    parts.push_back(part);
  }
  if (outside_heights_ > 0)
    parts.push_back(count_text(outside_heights_, "shape") + " below " +
                    format_number(options_.z_min) + " m or above " + format_number(options_.z_max) +
                    " m");
  return join(parts, "; ");
}

Bounds WorldParts::extent() const {
  Bounds all{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  const auto include = [&](const TPoint2D& p, double radius) {
    all = {std::min(all.x_min, p.x - radius), std::min(all.y_min, p.y - radius),
           std::max(all.x_max, p.x + radius), std::max(all.y_max, p.y + radius)};
  };
  for (const Disc& disc : obstacles_.discs) include(disc.center, disc.radius);
  for (const Polygon& polygon : obstacles_.polygons)
    for (const TPoint2D& corner : polygon.vertices) include(corner, 0);
  for (const Mover& mover : movers_)
    for (const Waypoint& waypoint : mover.waypoints) include(waypoint.position, mover.radius);
  if (start_) include({start_->x, start_->y}, 0);
  if (goal_) include(*goal_, 0);
  return all;
}

Scenario WorldParts::continuous(const std::string& name) const {
  const Bounds all = extent();
  const double margin = options_.margin;
  const Bounds around{all.x_min - margin, all.y_min - margin, all.x_max + margin,
                      all.y_max + margin};
  const Bounds bounds = bounds_.value_or(around);
  const TPoint2D corner(bounds.x_min, bounds.y_min);
  return Scenario::continuous(name, bounds, obstacles_, {corner.x, corner.y, 0}, corner);
}

/// The grid, extended by free cells so that it holds the obstacles, with the cells that they touch.
Scenario WorldParts::on_grid(const std::string& name) const {
  using Map = mrpt::maps::COccupancyGridMap2D;
  const double cell = grid_->getResolution();
  const Bounds all = extent();
  const auto cells = [&](double length) {
    return static_cast<int>(std::ceil(std::clamp(length / cell, 0.0, kMaxGridCells)));
  };
  const int left = cells(grid_->getXMin() - all.x_min), below = cells(grid_->getYMin() - all.y_min),
            right = cells(all.x_max - grid_->getXMax()),
            above = cells(all.y_max - grid_->getYMax());
  const TPoint2D corner(grid_->getXMin() - left * cell, grid_->getYMin() - below * cell);
  const int size_x = static_cast<int>(grid_->getSizeX()),
            size_y = static_cast<int>(grid_->getSizeY());
  Map map = left + below + right + above == 0
                ? *grid_
                : make_grid_map(size_x + left + right, size_y + below + above, cell, corner);
  for (int y = 0; y < size_y; ++y)
    for (int x = 0; x < size_x; ++x) map.setCell(x + left, y + below, grid_->getCell(x, y));
  if (!obstacles_.discs.empty() || !obstacles_.polygons.empty()) {
    const Bounds bounds{corner.x, corner.y, corner.x + static_cast<double>(map.getSizeX()) * cell,
                        corner.y + static_cast<double>(map.getSizeY()) * cell};
    const Occupancy touched = make_occupancy(
        Scenario::continuous(name, bounds, obstacles_, {corner.x, corner.y, 0}, corner), cell);
    for (int y = 0; y < std::min(touched.size_y(), static_cast<int>(map.getSizeY())); ++y)
      for (int x = 0; x < std::min(touched.size_x(), static_cast<int>(map.getSizeX())); ++x)
        if (touched.occupied(x, y)) map.setCell(x, y, 0.0F);
  }
  const TPoint2D inside(map.getXMin(), map.getYMin());
  return Scenario::grid(name, map, {inside.x, inside.y, 0}, inside);
}

ImportedWorld WorldParts::finish(const std::string& name) const {
  const std::string left_out = left_out_text();
  if (!grid_ && !bounds_ && obstacles_.discs.empty() && obstacles_.polygons.empty() &&
      movers_.empty())
    throw file_error(where_,
                     "contains no obstacle that can be imported" +
                         (left_out.empty() ? "" : ", left out: " + left_out),
                     "boxes, cylinders, spheres or polygons");
  Scenario scenario = grid_ ? on_grid(name) : continuous(name);
  if (start_ && goal_) scenario = scenario.with_start_goal(*start_, *goal_);
  if (!movers_.empty()) scenario = scenario.with_movers(movers_);
  return {std::move(scenario), start_, goal_,
          left_out.empty() ? "" : where_ + ": left out: " + left_out};
}

}  // namespace slalom
