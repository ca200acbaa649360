// SPDX-License-Identifier: BSD-3-Clause
#include "common/cost_to_go.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace reactive {
namespace {

constexpr std::int32_t kUnit = Wavefront::kMinWeight;  // weights are in tenths
constexpr std::int32_t kMaxWeight = 20 * kUnit;        // weight of cells too close to obstacles
constexpr double kEscapeRange = 0.3;                   // m around the robot where these are allowed

}  // namespace

void CostToGo::compute(const ClearanceMap& map, const Point& goal, const Point& robot,
                       const PathCosts& costs, double slack) {
  begin(map);
  weigh(costs);
  open_around(robot);
  bound_ahead(robot);
  seed(goal);
  spread(slack);
}

void CostToGo::compute(const ClearanceMap& map, const std::vector<Point>& goals, const Point& robot,
                       const PathCosts& costs, double slack) {
  begin(map);
  weigh(costs);
  open_around(robot);
  bound_ahead(robot);
  for (const Point& goal : goals) seed_inside(goal);
  spread(slack);
}

void CostToGo::compute(const Costmap& map, const Point& goal, const Point& robot) {
  begin(map.clearance());
  for (int y = 0; y < map_->side(); ++y)
    for (int x = 0; x < map_->side(); ++x) {
      const int cost = map.cost(x, y);
      const bool open = cost < Inflation::kInscribed;
      const std::size_t cell = map_->index(x, y);
      front_.weights[cell] = open ? kUnit + kUnit * 8 * cost / 500 : 0;
      front_.costs[cell] = open ? Wavefront::kUnreached : Wavefront::kBlocked;
    }
  open_around(robot);
  bound_ahead(robot);
  seed(goal);
  spread(0);
}

void CostToGo::begin(const ClearanceMap& map) {
  map_ = &map;
  if (front_.side != map.side() || resolution_ != map.resolution()) {
    front_.resize(map.side());
    resolution_ = map.resolution();
    center_ = kNoCell;
  }
  front_.clear();
}

void CostToGo::weigh(const PathCosts& costs) {
  const double span = std::max(1e-6, costs.comfort - costs.clearance);
  fill_weights({costs.clearance, costs.comfort, span, costs.comfort_weight, kUnit},
               map_->cells().data(), map_->index(0, map_->side()), kMaxWeight, Wavefront::kBlocked,
               Wavefront::kUnreached, front_.weights.data(), front_.costs.data());
}

void CostToGo::spread(double slack) {
  const bool inside = target_ != kNoCell;
  const std::size_t everywhere = std::numeric_limits<std::size_t>::max();
  if (inside) front_.spread_to(target_);
  const bool reached = inside && front_.costs[target_] != Wavefront::kUnreached;
  end_ = reached ? front_.next_bucket + static_cast<std::size_t>(slack / map_->resolution())
                 : everywhere;
  if (!inside) front_.spread_before(everywhere);
}

/// Opens the blocked cells around the robot, at a high cost.
void CostToGo::open_around(const Point& robot) {
  int cx = 0, cy = 0;
  if (!map_->cell_at(robot, cx, cy)) return;
  const int reach = static_cast<int>(kEscapeRange / map_->resolution()) + 1;
  const int last = map_->side() - 1;
  for (int y = std::max(0, cy - reach); y <= std::min(last, cy + reach); ++y)
    for (int x = std::max(0, cx - reach); x <= std::min(last, cx + reach); ++x) {
      const std::size_t cell = map_->index(x, y);
      if (front_.weights[cell] > 0 || distance(map_->center_of(x, y), robot) >= kEscapeRange)
        continue;
      front_.weights[cell] = kMaxWeight;
      front_.costs[cell] = Wavefront::kUnreached;
    }
}

/// The cost of a path in free space to the cells within reach of the robot, measured as such a
/// path: 1.08 is more than the ratio of its length to the distance; 3 cells are for interpolation.
/// With a larger reach it also holds while the robot moves a little.
void CostToGo::bound_ahead(const Point& robot) {
  constexpr int kMoved = 10;  // cells
  int robot_x = 0, robot_y = 0;
  const bool inside = map_->cell_at(robot, robot_x, robot_y);
  target_ = inside ? map_->index(robot_x, robot_y) : kNoCell;
  const int side = map_->side(), last = side - 1;
  if (inside && center_ != kNoCell) {
    const auto cells = static_cast<std::size_t>(side);
    const int dx = std::abs(static_cast<int>(center_ % cells) - robot_x);
    const int dy = std::abs(static_cast<int>(center_ / cells) - robot_y);
    if (std::max(dx, dy) <= kMoved) return;
  }
  center_ = target_;
  std::fill(front_.ahead.begin(), front_.ahead.end(), Wavefront::kBorder);
  const double disc =
      Wavefront::kBucketWidth * (1.08 * reach_ / map_->resolution() + 3 + 1.4 * kMoved);
  const double everywhere = 1.0 * Wavefront::kDiagonal * kUnit * side;
  const auto within = static_cast<std::int32_t>(inside ? std::min(disc, everywhere) : everywhere);
  for (int y = 1; y < last; ++y)
    for (int x = 1; x < last; ++x) {
      const int dx = std::abs(x - robot_x), dy = std::abs(y - robot_y);
      const std::int32_t path = Wavefront::kStraight * std::max(dx, dy) +
                                (Wavefront::kDiagonal - Wavefront::kStraight) * std::min(dx, dy);
      front_.ahead[map_->index(x, y)] = std::max(0, kUnit * path - within);
    }
}

void CostToGo::seed(const Point& goal) {
  if (!seed_inside(goal)) seed_border(goal);
}

/// Whether `goal` is inside the border of the map, where its cell becomes a goal.
bool CostToGo::seed_inside(const Point& goal) {
  const int last = map_->side() - 1;
  int x = 0, y = 0;
  const bool inside = map_->cell_at(goal, x, y) && std::min(x, y) > 0 && std::max(x, y) < last;
  if (!inside) return false;
  front_.costs[map_->index(x, y)] = Wavefront::kUnreached;  // also of a blocked cell
  front_.improve(map_->index(x, y), 0);
  return true;
}

/// Beyond the map paths are straight: the border starts with its distances to the goal, minus their
/// minimum, and the cells inside the border with a diagonal step from there.
void CostToGo::seed_border(const Point& goal) {
  struct Seed {
    std::size_t cell, inner;
    double goal_distance;
  };
  const int last = map_->side() - 1;
  std::vector<Seed> border;
  double nearest = HUGE_VAL;
  const auto add = [&](int x, int y) {
    const std::size_t cell = map_->index(x, y);
    if (front_.weights[cell] == 0) return;
    const std::size_t inner = map_->index(std::clamp(x, 1, last - 1), std::clamp(y, 1, last - 1));
    border.push_back({cell, inner, distance(map_->center_of(x, y), goal)});
    nearest = std::min(nearest, border.back().goal_distance);
  };
  for (int i = 0; i <= last; ++i) {
    add(i, 0);
    add(i, last);
    add(0, i);
    add(last, i);
  }
  for (const Seed& seed : border) {
    const auto cost = static_cast<std::int32_t>((seed.goal_distance - nearest) /
                                                map_->resolution() * Wavefront::kBucketWidth);
    front_.improve(seed.cell, cost);
    front_.improve(seed.inner, cost + Wavefront::kDiagonal * front_.weights[seed.inner]);
  }
}

double CostToGo::cell_cost(int x, int y) const {
  if (x < 0 || y < 0 || x >= map_->side() || y >= map_->side()) return kUnreached;
  const std::int32_t cost = front_.costs[map_->index(x, y)];
  if (cost == Wavefront::kUnreached || cost == Wavefront::kBlocked) return kUnreached;
  return cost * map_->resolution() / Wavefront::kBucketWidth;
}

/// Spreads the wavefront to the four cells around an interpolated position.
void CostToGo::settle(int x, int y) {
  constexpr std::size_t kMore = 5;  // buckets, each a cell's side wide
  const auto settled = [&](int column, int row) {
    if (std::min(column, row) < 0 || std::max(column, row) >= map_->side()) return true;
    const std::int32_t cost = front_.costs[map_->index(column, row)];
    return cost == Wavefront::kBlocked || front_.is_final(cost);
  };
  while (front_.next_bucket < std::min(end_, front_.buckets.size()) &&
         !(settled(x, y) && settled(x + 1, y) && settled(x, y + 1) && settled(x + 1, y + 1)))
    front_.spread_before(std::min(end_, front_.next_bucket + kMore));
}

double CostToGo::at(const Point& p) {
  int x = 0, y = 0;
  if (!map_->cell_at(p, x, y)) return kUnreached;
  const Point center = map_->center_of(x, y);
  const double r = map_->resolution();
  const int ix = p.x < center.x ? x - 1 : x, iy = p.y < center.y ? y - 1 : y;
  settle(ix, iy);
  const Point low = map_->center_of(ix, iy);
  const double fx = (p.x - low.x) / r, fy = (p.y - low.y) / r;
  double sum = 0, weight = 0;
  for (int k = 0; k < 4; ++k) {
    const int dx = k % 2, dy = k / 2;
    const double cost = cell_cost(ix + dx, iy + dy);
    if (cost >= kUnreached) continue;
    const double fraction = (dx != 0 ? fx : 1 - fx) * (dy != 0 ? fy : 1 - fy);
    sum += fraction * cost;
    weight += fraction;
  }
  return weight > 1e-3 ? sum / weight : kUnreached;
}

bool CostToGo::nearest_reached(const Point& from, int& x, int& y) const {
  int cx = 0, cy = 0;
  if (!map_->cell_at(from, cx, cy)) return false;
  const int reach = static_cast<int>(kEscapeRange / map_->resolution());
  double best = HUGE_VAL;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      if (cell_cost(cx + dx, cy + dy) >= kUnreached || dx * dx + dy * dy >= best) continue;
      best = dx * dx + dy * dy;
      x = cx + dx;
      y = cy + dy;
    }
  return best < HUGE_VAL;
}

std::vector<Point> CostToGo::path(const Point& from, double length) const {
  std::vector<Point> result;
  int x = 0, y = 0;
  if (!nearest_reached(from, x, y)) return result;
  const auto max_size = static_cast<std::size_t>(length / map_->resolution());
  result.push_back(map_->center_of(x, y));
  while (result.size() < max_size) {
    int bx = x, by = y;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (cell_cost(x + dx, y + dy) < cell_cost(bx, by)) {
          bx = x + dx;
          by = y + dy;
        }
    if (bx == x && by == y) break;
    x = bx;
    y = by;
    result.push_back(map_->center_of(x, y));
  }
  return result;
}

bool line_is_free(const ClearanceMap& map, const Point& a, const Point& b, double clearance) {
  const double length = distance(a, b);
  const double step = 0.5 * map.resolution();
  const int steps = static_cast<int>(length / step) + 1;
  for (int i = 1; i <= steps; ++i) {
    const double fraction = static_cast<double>(i) / steps;
    if (map.at({a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y)}) < clearance)
      return false;
  }
  return true;
}

Point farthest_visible(const ClearanceMap& map, const Point& from, const std::vector<Point>& path,
                       double clearance) {
  Point best = path.empty() ? from : path.front();
  for (const Point& p : path) {
    if (!line_is_free(map, from, p, clearance)) break;
    best = p;
  }
  return best;
}

}  // namespace reactive
