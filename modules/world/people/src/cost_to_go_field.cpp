// SPDX-License-Identifier: BSD-3-Clause
#include "line_of_sight.h"

#include <slalom/people/cost_to_go_field.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Lengths of steps, exact when summed: 1393/985 is the square root of 2 within 4e-7.
constexpr int kStraight = 985, kDiagonal = 1393;

struct Direction {
  int x, y;
  int cost() const { return x != 0 && y != 0 ? kDiagonal : kStraight; }
};

constexpr std::array<Direction, 8> kDirections{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
constexpr double kBorder = 1e-9;  // cells
constexpr std::uint8_t kGoal = 8, kNoWay = 9;
constexpr auto kFar = std::numeric_limits<std::int64_t>::max();

/// Greater for the better one of two steps of the same way's length: that nearer to the direction
/// (x, y) of the goal, then that on the side.
std::tuple<std::int64_t, std::int64_t> preference(const Direction& step, std::int64_t x,
                                                  std::int64_t y, int side) {
  const std::int64_t ahead = step.x * x + step.y * y, aside = x * step.y - y * step.x;
  // Signed squares of cosines, times the same number.
  const std::int64_t cosine = ahead * std::abs(ahead) * (step.x != 0 && step.y != 0 ? 1 : 2);
  return {cosine, side * aside};
}

}  // namespace

CostToGoField::CostToGoField(const World& world, const TPoint2D& goal, double radius,
                             PeopleSide side)
    : occupancy_(world.occupancy()),
      field_(world.distance_field()),
      caster_(world.ray_caster()),
      goal_(goal),
      radius_(radius),
      side_(side == PeopleSide::Left ? 1 : -1),
      goal_first_(cell_at(goal, -kBorder)),
      goal_last_(cell_at(goal, kBorder)),
      steps_(occupancy_.cells().size(), kNoWay) {
  choose_steps(costs());
}

/// The cell of p, shifted by so many cells along both axes.
CostToGoField::Cell CostToGoField::cell_at(const TPoint2D& p, double shift) const {
  const TPoint2D at = occupancy_.to_cells(p);
  const auto inside = [](double x, int size) {
    return static_cast<int>(std::clamp(std::floor(x), 0.0, size - 1.0));
  };
  return {inside(at.x + shift, occupancy_.size_x()), inside(at.y + shift, occupancy_.size_y())};
}

bool CostToGoField::has_room(const Cell& cell) const {
  return occupancy_.inside(cell.x, cell.y) && field_.at_center(cell.x, cell.y) >= radius_;
}

/// Dijkstra's search from the goal, with a bucket for each cost that is open (Dial 1969).
std::vector<std::int64_t> CostToGoField::costs() const {
  std::vector<std::int64_t> costs(steps_.size(), kFar);
  std::vector<std::vector<std::size_t>> buckets(kDiagonal + 1);
  std::size_t open = 0;
  const auto reach = [&](std::size_t cell, std::int64_t cost) {
    if (cost >= costs[cell]) return;
    costs[cell] = cost;
    buckets[static_cast<std::size_t>(cost) % buckets.size()].push_back(cell);
    ++open;
  };
  for (int y = goal_first_.y; y <= goal_last_.y; ++y)
    for (int x = goal_first_.x; x <= goal_last_.x; ++x) reach(occupancy_.index(x, y), 0);
  const auto size_x = static_cast<std::size_t>(occupancy_.size_x());
  for (std::int64_t cost = 0; open > 0; ++cost) {
    std::vector<std::size_t>& bucket = buckets[static_cast<std::size_t>(cost) % buckets.size()];
    for (const std::size_t here : bucket) {
      if (costs[here] != cost) continue;
      const int x = static_cast<int>(here % size_x), y = static_cast<int>(here / size_x);
      for (const Direction& d : kDirections)
        if (has_room({x + d.x, y + d.y}))
          reach(occupancy_.index(x + d.x, y + d.y), cost + d.cost());
    }
    open -= bucket.size();
    bucket.clear();
  }
  return costs;
}

void CostToGoField::choose_steps(const std::vector<std::int64_t>& costs) {
  for (int y = 0; y < occupancy_.size_y(); ++y)
    for (int x = 0; x < occupancy_.size_x(); ++x) {
      const std::size_t here = occupancy_.index(x, y);
      if (costs[here] == kFar) continue;
      steps_[here] = kGoal;
      auto best = std::make_tuple(-kFar, -kFar);
      for (std::size_t i = 0; i < kDirections.size(); ++i) {
        const Direction& d = kDirections[i];
        if (!occupancy_.inside(x + d.x, y + d.y)) continue;
        const std::int64_t cost = costs[occupancy_.index(x + d.x, y + d.y)];
        if (cost == kFar || cost + d.cost() != costs[here]) continue;
        const auto value = preference(d, goal_first_.x + goal_last_.x - 2 * x,
                                      goal_first_.y + goal_last_.y - 2 * y, side_);
        if (value <= best) continue;
        best = value;
        steps_[here] = static_cast<std::uint8_t>(i);
      }
    }
}

bool CostToGoField::can_walk(const TPoint2D& from, const TPoint2D& to) const {
  constexpr double kTolerance = 1e-3;  // m, for people who touch a wall
  // Where a wall is between the two, the distance takes longer to compute.
  return is_in_sight(caster_, from, to) &&
         field_.segment_clearance(from, to, radius_) >= radius_ - kTolerance;
}

std::optional<CostToGoField::Cell> CostToGoField::nearest_with_way(const TPoint2D& p,
                                                                   int reach) const {
  const Cell center = cell_at(p, 0);
  const TPoint2D ahead = goal_ - p;
  auto nearest = std::make_tuple(std::numeric_limits<double>::infinity(), 0.0, 0.0);
  std::optional<Cell> cell;
  for (int y = center.y - reach; y <= center.y + reach; ++y)
    for (int x = center.x - reach; x <= center.x + reach; ++x) {
      if (!occupancy_.inside(x, y) || step({x, y}) == kNoWay) continue;
      const TPoint2D offset = occupancy_.cell_center(x, y) - p;
      const auto place =
          std::make_tuple(dot(offset, offset), -dot(offset, ahead), -side_ * cross(ahead, offset));
      if (!(place < nearest)) continue;
      nearest = place;
      cell = Cell{x, y};
    }
  return cell;
}

CostToGoField::Cell CostToGoField::next(const Cell& cell) const {
  const Direction& d = kDirections[step(cell)];
  return {cell.x + d.x, cell.y + d.y};
}

TPoint2D CostToGoField::farthest_from(const TPoint2D& p, const Cell& nearest) const {
  constexpr double kLookahead = 8;  // m
  const auto most = static_cast<std::size_t>(std::ceil(kLookahead / occupancy_.resolution()));
  std::vector<TPoint2D> way;
  way.reserve(most);
  for (Cell cell = nearest;; cell = next(cell)) {
    way.push_back(occupancy_.cell_center(cell.x, cell.y));
    if (way.size() == most || step(cell) == kGoal) break;
  }
  std::size_t low = 0, high = way.size() - 1;  // visible up to `low`
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    if (can_walk(p, way[middle]))
      low = middle;
    else
      high = middle - 1;
  }
  return way[low];
}

/// Moves on along the way by strides, as far as the person can walk straight.
TPoint2D CostToGoField::further(const TPoint2D& p, TPoint2D target) const {
  constexpr double kStride = 0.2;  // m
  const int stride = std::max(1, static_cast<int>(kStride / occupancy_.resolution()));
  for (Cell cell = cell_at(target, 0); step(cell) < kGoal;) {
    for (int i = 0; i < stride && step(cell) < kGoal; ++i) cell = next(cell);
    const TPoint2D center = occupancy_.cell_center(cell.x, cell.y);
    if (!can_walk(p, center)) break;
    target = center;
  }
  return target;
}

TPoint2D CostToGoField::target(const TPoint2D& p, const std::optional<TPoint2D>& previous) const {
  constexpr double kNear = 0.3;  // m: strides may be too long around a corner
  if (can_walk(p, goal_)) return goal_;
  if (previous && can_walk(p, *previous))
    if (const TPoint2D target = further(p, *previous); norm(target - p) > kNear) return target;
  auto nearest = nearest_with_way(p, 1);
  if (!nearest)
    nearest =
        nearest_with_way(p, static_cast<int>(std::ceil(radius_ / occupancy_.resolution())) + 1);
  return nearest ? farthest_from(p, *nearest) : goal_;
}

double CostToGoField::length(const TPoint2D& p, const TPoint2D& target) const {
  const double straight = norm(target - p);
  if (target.x == goal_.x && target.y == goal_.y) return straight;
  Cell cell = cell_at(target, 0);
  int steps = 0, diagonals = 0;
  for (; step(cell) < kGoal; cell = next(cell)) {
    const Direction& d = kDirections[step(cell)];
    ++(d.x != 0 && d.y != 0 ? diagonals : steps);
  }
  return straight + occupancy_.resolution() * (steps + diagonals * std::sqrt(2.0)) +
         norm(goal_ - occupancy_.cell_center(cell.x, cell.y));
}

}  // namespace slalom
