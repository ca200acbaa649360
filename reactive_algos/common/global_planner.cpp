// SPDX-License-Identifier: BSD-3-Clause
#include "common/global_planner.h"

namespace reactive {

std::vector<Point> GlobalPlanner::plan(const Costmap& map, const Point& start, const Point& goal) {
  cost_to_go_.compute(map, goal, start);
  const double cells = 1.0 * map.clearance().side() * map.clearance().side();
  std::vector<Point> path = cost_to_go_.path(start, cells * map.clearance().resolution());
  if (!path.empty()) path.push_back(goal);
  return path;
}

GlobalCostmap::GlobalCostmap(double half_size, double resolution, const Inflation& inflation)
    : half_size_(half_size), resolution_(resolution), costs_(half_size, resolution, inflation) {}

/// Cells of the map that are larger than those of the costmap become several points.
void GlobalCostmap::set_known(const KnownMap& map) {
  points_.clear();
  const int parts = std::max(1, static_cast<int>(std::ceil(map.resolution / resolution_ - 1e-9)));
  const double step = map.resolution / parts;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (map.cells[i] == 0) continue;
    const double x = map.origin.x + static_cast<double>(i % map.size_x) * map.resolution;
    const std::size_t map_row = i / map.size_x;
    const double y = map.origin.y + static_cast<double>(map_row) * map.resolution;
    for (int row = 0; row < parts; ++row)
      for (int column = 0; column < parts; ++column)
        points_.push_back({x + (column + 0.5) * step, y + (row + 0.5) * step});
  }
  known_points_ = points_.size();
  known_ = true;
  const double width = static_cast<double>(map.size_x) * map.resolution;
  const double height = static_cast<double>(map.size_y) * map.resolution;
  center_ = {map.origin.x + 0.5 * width, map.origin.y + 0.5 * height};
  constexpr double kBorder = 0.5;  // m, around the map
  half_size_ = 0.5 * std::max(width, height) + kBorder;
  costs_ = Costmap(half_size_, resolution_, costs_.inflation());
}

void GlobalCostmap::take_over(GlobalCostmap& before) {
  known_ = before.known_;
  center_ = before.center_;
  points_ = std::move(before.points_);
  known_points_ = before.known_points_;
  half_size_ = before.half_size_;
  costs_ = Costmap(half_size_, resolution_, costs_.inflation());
}

void GlobalCostmap::build(const Point& robot, const std::vector<Point>& sensed) {
  points_.resize(known_points_);
  points_.insert(points_.end(), sensed.begin(), sensed.end());
  costs_.build(known_ ? center_ : robot, points_);
}

}  // namespace reactive
