// SPDX-License-Identifier: BSD-3-Clause
#include "dwa_local_planner/footprint.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace dwa_local_planner {

using namespace reactive;

namespace {

std::vector<Point> padded_corners(const Robot& robot, double padding) {
  constexpr int kCorners = 16;  // of a disc
  std::vector<Point> corners = robot.footprint;
  if (corners.empty())
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2 * M_PI * i / kCorners;
      corners.push_back(
          {robot.radius * slalom::math::cos(angle), robot.radius * slalom::math::sin(angle)});
    }
  const auto away = [&](double c) {
    return std::abs(c) < 1e-9 ? c : c + std::copysign(padding, c);
  };
  for (Point& p : corners) p = {away(p.x), away(p.y)};
  return corners;
}

/// The highest cost of the cells on the line between two cells (Bresenham 1965).
std::uint8_t line_cost(const Costmap& map, int x, int y, int to_x, int to_y) {
  const int side = map.clearance().side();
  const int dx = std::abs(to_x - x), dy = std::abs(to_y - y);
  const int step_x = x < to_x ? 1 : -1, step_y = y < to_y ? 1 : -1;
  int error = dx - dy;
  std::uint8_t highest = 0;
  for (int i = std::max(dx, dy); i >= 0; --i) {
    if (x >= 0 && y >= 0 && x < side && y < side) highest = std::max(highest, map.cost(x, y));
    const int twice = 2 * error;
    if (twice > -dy) {
      error -= dy;
      x += step_x;
    }
    if (twice < dx) {
      error += dx;
      y += step_y;
    }
  }
  return highest;
}

}  // namespace

Footprint::Footprint(const Robot& robot, double padding)
    : Footprint(padded_corners(robot, padding)) {}

Footprint::Footprint(std::vector<Point> corners) : corners_(std::move(corners)) {
  circumscribed_radius_ = 0;
  for (const Point& p : corners_)
    circumscribed_radius_ = std::max(circumscribed_radius_, slalom::math::hypot(p.x, p.y));
  Robot shape;
  shape.radius = circumscribed_radius_;
  shape.footprint = corners_;
  inscribed_radius_ = reactive::inscribed_radius(shape);
}

Footprint Footprint::scaled(double factor) const {
  std::vector<Point> corners = corners_;
  for (Point& p : corners) p = {factor * p.x, factor * p.y};
  return Footprint(corners);
}

std::uint8_t Footprint::cost(const Costmap& map, const Point& position, double cosine,
                             double sine) const {
  const ClearanceMap& grid = map.clearance();
  int x = 0, y = 0;
  const double free = circumscribed_radius_ + map.inflation().inflation_radius + grid.resolution();
  if (grid.band() >= free && grid.cell_at(position, x, y) && grid.cell(x, y) > free) return 0;
  const auto cell_of = [&](const Point& p, int& column, int& row) {
    const double world_x = position.x + cosine * p.x - sine * p.y;
    const double world_y = position.y + sine * p.x + cosine * p.y;
    column = static_cast<int>(std::floor((world_x - grid.origin().x) / grid.resolution()));
    row = static_cast<int>(std::floor((world_y - grid.origin().y) / grid.resolution()));
  };
  std::uint8_t highest = 0;
  cell_of(corners_.back(), x, y);
  for (const Point& p : corners_) {
    int to_x = 0, to_y = 0;
    cell_of(p, to_x, to_y);
    highest = std::max(highest, line_cost(map, x, y, to_x, to_y));
    if (highest == Inflation::kLethal) break;
    x = to_x;
    y = to_y;
  }
  return highest;
}

}  // namespace dwa_local_planner
