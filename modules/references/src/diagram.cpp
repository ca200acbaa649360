#include "diagram.h"

#include <slalom/references/voronoi_diagram.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

namespace slalom {
namespace {

/// Octile distance (cells): the length of the shortest 8-connected path without obstacles.
double octile(const GridCell& a, const GridCell& b) {
  const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  return std::max(dx, dy) + (kDiagonal - 1) * std::min(dx, dy);
}

}  // namespace

Diagram::Diagram(const World& world, double bottleneck, const GridCell (&ends)[2])
    : cells_(world.occupancy()),
      field_(world.distance_field()),
      stride_(static_cast<std::size_t>(cells_.size_x()) + 2),
      kinds_(stride_ * (static_cast<std::size_t>(cells_.size_y()) + 2), Kind::Occupied) {
  for (int y = 0; y < cells_.size_y(); ++y)
    for (int x = 0; x < cells_.size_x(); ++x) {
      if (cells_.occupied(x, y)) continue;
      const bool wide = field_.at_center(x, y) >= bottleneck;
      kinds_[index(x, y)] = !wide                               ? Kind::Narrow
                            : is_on_ridge(cells_, field_, x, y) ? Kind::Ridge
                                                                : Kind::Wide;
    }
  for (const GridCell& end : ends)
    if (Kind& kind = kinds_[index(end.x, end.y)]; kind == Kind::Narrow) kind = Kind::Wide;
}

double Diagram::d(int x, int y) const {
  return cells_.inside(x, y) ? field_.at_center(x, y) : 0.0;
}

std::vector<GridCell> Diagram::ascend(const GridCell& from) const {
  std::vector<GridCell> path = {from};
  while (!contains(path.back())) {
    const GridCell at = path.back();
    double best_slope = 0;
    GridCell best = at;
    for (const Step& step : kSteps) {
      if (!may_step(at, step)) continue;
      const double slope = (d(at.x + step.dx, at.y + step.dy) - d(at.x, at.y)) / step.length;
      if (slope <= best_slope) continue;
      best_slope = slope;
      best = {at.x + step.dx, at.y + step.dy};
    }
    if (best == at) break;
    path.push_back(best);
  }
  return path;
}

std::vector<GridCell> Diagram::shortest(const GridCell& from, const GridCell& to) const {
  constexpr std::int8_t kNotReached = -1;
  std::vector<double> cost(kinds_.size(), std::numeric_limits<double>::infinity());
  std::vector<std::int8_t> came_by(kinds_.size(), kNotReached);
  struct Entry {
    double estimate, so_far;
    GridCell at;
    bool operator>(const Entry& other) const {  // ties: closest to the target first
      if (estimate != other.estimate) return estimate > other.estimate;
      if (so_far != other.so_far) return so_far < other.so_far;
      return at.y != other.at.y ? at.y > other.at.y : at.x > other.at.x;
    }
  };
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  cost[index(from.x, from.y)] = 0;
  queue.push({octile(from, to), 0, from});
  while (!queue.empty() && !(queue.top().at == to)) {
    const Entry entry = queue.top();
    queue.pop();
    if (entry.so_far > cost[index(entry.at.x, entry.at.y)]) continue;
    for (std::size_t s = 0; s < std::size(kSteps); ++s) {
      if (!may_step(entry.at, kSteps[s])) continue;
      const GridCell next{entry.at.x + kSteps[s].dx, entry.at.y + kSteps[s].dy};
      const double total = entry.so_far + (contains(next) ? 1 : kOffDiagramCost) * kSteps[s].length;
      const std::size_t n = index(next.x, next.y);
      if (total >= cost[n]) continue;
      cost[n] = total;
      came_by[n] = static_cast<std::int8_t>(s);
      queue.push({total + octile(next, to), total, next});
    }
  }
  if (queue.empty()) return {};
  std::vector<GridCell> path = {to};
  while (!(path.back() == from)) {
    const Step& step = kSteps[came_by[index(path.back().x, path.back().y)]];
    path.push_back({path.back().x - step.dx, path.back().y - step.dy});
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace slalom
