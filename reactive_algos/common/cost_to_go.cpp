#include "common/cost_to_go.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace reactive {
namespace {

constexpr std::int32_t kInfinite = std::numeric_limits<std::int32_t>::max();
constexpr std::int32_t kUnit = 10;                      // weights are in tenths
constexpr std::int32_t kStraight = 10, kDiagonal = 14;  // of a step, in tenths of a cell
constexpr std::int32_t kMaxWeight = 20 * kUnit;         // weight of cells too close to obstacles
constexpr double kEscapeRange = 0.3;  // m around the robot where these are allowed
// Not wider than the cheapest step, so the order within a bucket is irrelevant (Denardo and Fox
// 1979).
constexpr std::int32_t kBucketWidth = kStraight * kUnit;

}  // namespace

void CostToGo::compute(const ClearanceMap& map, const Point& goal, const Point& robot,
                       const PathCosts& costs, double slack) {
  map_ = &map;
  const auto cells = static_cast<std::size_t>(map.side()) * static_cast<std::size_t>(map.side());
  cost_.assign(cells, kInfinite);
  weight_.resize(cells);
  for (auto& bucket : buckets_) bucket.clear();
  weigh(robot, costs);
  seed(goal);
  spread(robot, slack);
}

void CostToGo::weigh(const Point& robot, const PathCosts& costs) {
  const int side = map_->side();
  const double span = std::max(1e-6, costs.comfort - costs.clearance);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double clearance = map_->cell(x, y);
      const double deficit = std::clamp((costs.comfort - clearance) / span, 0.0, 1.0);
      std::int32_t weight =
          kUnit + static_cast<std::int32_t>(costs.comfort_weight * deficit * kUnit);
      if (clearance < costs.clearance)
        weight = distance(map_->center_of(x, y), robot) < kEscapeRange ? kMaxWeight : 0;
      weight_[map_->index(x, y)] = std::min(weight, kMaxWeight);
    }
}

void CostToGo::push(std::int32_t cell, std::int32_t cost) {
  std::int32_t& known = cost_[static_cast<std::size_t>(cell)];
  if (cost >= known) return;
  known = cost;
  const auto bucket = static_cast<std::size_t>(cost / kBucketWidth);
  if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
  buckets_[bucket].push_back({cell, cost});
}

void CostToGo::seed(const Point& goal) {
  const int last = map_->side() - 1;
  int x = 0, y = 0;
  const bool inside = map_->cell_at(goal, x, y) && std::min(x, y) > 0 && std::max(x, y) < last;
  if (inside)
    push(static_cast<std::int32_t>(map_->index(x, y)), 0);
  else
    seed_border(goal);
}

/// Beyond the map paths are straight: the border starts with its distances to the goal, minus their
/// minimum.
void CostToGo::seed_border(const Point& goal) {
  const int last = map_->side() - 1;
  std::vector<std::pair<double, std::int32_t>> border;
  double nearest = HUGE_VAL;
  const auto add = [&](int x, int y) {
    const std::size_t cell = map_->index(x, y);
    if (weight_[cell] == 0) return;
    border.emplace_back(distance(map_->center_of(x, y), goal), static_cast<std::int32_t>(cell));
    nearest = std::min(nearest, border.back().first);
  };
  for (int i = 0; i <= last; ++i) {
    add(i, 0);
    add(i, last);
    add(0, i);
    add(last, i);
  }
  for (const auto& [goal_distance, cell] : border)
    push(cell,
         static_cast<std::int32_t>((goal_distance - nearest) / map_->resolution() * kBucketWidth));
}

void CostToGo::expand(const Entry& entry) {
  const int side = map_->side();
  const int x = entry.cell % side, y = entry.cell / side;
  if (x == 0 || y == 0 || x == side - 1 || y == side - 1) {
    // Border cells propagate the wavefront inwards only.
    const int ix = std::clamp(x, 1, side - 2), iy = std::clamp(y, 1, side - 2);
    const std::size_t inner = map_->index(ix, iy);
    if (weight_[inner] > 0)
      push(static_cast<std::int32_t>(inner), entry.cost + kDiagonal * weight_[inner]);
    return;
  }
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const std::size_t next = map_->index(x + dx, y + dy);
      if (weight_[next] == 0) continue;
      const std::int32_t step = dx != 0 && dy != 0 ? kDiagonal : kStraight;
      push(static_cast<std::int32_t>(next), entry.cost + step * weight_[next]);
    }
}

void CostToGo::spread(const Point& robot, double slack) {
  int x = 0, y = 0;
  const bool inside = map_->cell_at(robot, x, y);
  const std::size_t robot_cell = inside ? map_->index(x, y) : 0;
  const double further = slack / map_->resolution();  // cells, one bucket each
  std::size_t end = std::numeric_limits<std::size_t>::max();
  for (std::size_t b = 0; b < buckets_.size() && b < end; ++b) {
    // Expanding appends only to later buckets, because each step costs at least one bucket.
    for (std::size_t i = 0; i < buckets_[b].size(); ++i) {
      const Entry entry = buckets_[b][i];
      if (entry.cost == cost_[static_cast<std::size_t>(entry.cell)]) expand(entry);
    }
    if (inside && end == std::numeric_limits<std::size_t>::max() &&
        cost_[robot_cell] != kInfinite &&
        static_cast<std::size_t>(cost_[robot_cell] / kBucketWidth) <= b)
      end = b + 1 + static_cast<std::size_t>(further);
  }
}

double CostToGo::cell_cost(int x, int y) const {
  if (x < 0 || y < 0 || x >= map_->side() || y >= map_->side()) return kUnreached;
  const std::int32_t cost = cost_[map_->index(x, y)];
  return cost == kInfinite ? kUnreached : cost * map_->resolution() / kBucketWidth;
}

double CostToGo::at(const Point& p) const {
  int x = 0, y = 0;
  if (!map_->cell_at(p, x, y)) return kUnreached;
  const Point center = map_->center_of(x, y);
  const double r = map_->resolution();
  const int ix = p.x < center.x ? x - 1 : x, iy = p.y < center.y ? y - 1 : y;
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
