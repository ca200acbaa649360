#include <slalom/references/safest_path.h>
#include <slalom/scenario/widest_path.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

struct Step {
  int dx, dy;
  double length;  // cells
};

constexpr double kDiagonal = 1.4142135623730951;
constexpr Step kSteps[] = {{1, 0, 1},          {-1, 0, 1},         {0, 1, 1},
                           {0, -1, 1},         {1, 1, kDiagonal},  {1, -1, kDiagonal},
                           {-1, 1, kDiagonal}, {-1, -1, kDiagonal}};

struct Cell {
  int x = 0, y = 0;
};

class SafestSearch {
 public:
  SafestSearch(const PlanningProblem& problem, double bottleneck)
      : cells_(problem.world.occupancy()),
        field_(problem.world.distance_field()),
        // d at centres is kept as float: the bottleneck itself must pass.
        least_(bottleneck - 1e-6),
        source_(cell_of(problem.start)),
        target_(cell_of(problem.goal)) {}

  /// Cells from source to target, both included.
  std::vector<Cell> run() {
    const std::vector<Cell> up = ascend(source_), down = ascend(target_);
    std::vector<Cell> path = along_diagram(up.back(), down.back());
    path.insert(path.begin(), up.begin(), up.end() - 1);
    path.insert(path.end(), down.rbegin() + 1, down.rend());
    return without_loops(path);
  }

 private:
  Cell cell_of(const TPoint2D& p) const {
    const TPoint2D at = cells_.to_cells(p);
    return {std::min(static_cast<int>(at.x), cells_.size_x() - 1),
            std::min(static_cast<int>(at.y), cells_.size_y() - 1)};
  }

  bool same(const Cell& a, const Cell& b) const { return a.x == b.x && a.y == b.y; }
  bool is_end(const Cell& c) const { return same(c, source_) || same(c, target_); }

  /// Free, wide enough (start and goal count at their exact positions), and not round a corner.
  bool may_step(const Cell& from, const Step& step) const {
    const Cell to{from.x + step.dx, from.y + step.dy};
    if (cells_.occupied(to.x, to.y) || cells_.occupied(from.x, to.y) ||
        cells_.occupied(to.x, from.y))
      return false;
    return is_end(to) || field_.at_center(to.x, to.y) >= least_;
  }

  double d(int x, int y) const { return cells_.occupied(x, y) ? 0.0 : field_.at_center(x, y); }

  /// On the diagram the nearest obstacles lie on different sides, so the slope of d falls below 1:
  /// it is the cosine of half the angle between the directions to them. 0.8 leaves out angles under
  /// 74 degrees, such as between the cells of one rough wall.
  bool is_on_diagram(const Cell& c) const {
    constexpr double kMaxSlope = 0.8;
    const double scale = 0.5 / cells_.resolution();
    const double gx = (d(c.x + 1, c.y) - d(c.x - 1, c.y)) * scale;
    const double gy = (d(c.x, c.y + 1) - d(c.x, c.y - 1)) * scale;
    return std::hypot(gx, gy) < kMaxSlope;
  }

  /// The way of steepest ascent of clearance from a cell to the diagram.
  std::vector<Cell> ascend(const Cell& from) const {
    std::vector<Cell> path = {from};
    while (!is_on_diagram(path.back())) {
      const Cell at = path.back();
      double best_slope = 0;
      Cell best = at;
      for (const Step& step : kSteps) {
        if (!may_step(at, step)) continue;
        const double slope = (d(at.x + step.dx, at.y + step.dy) - d(at.x, at.y)) / step.length;
        if (slope <= best_slope) continue;
        best_slope = slope;
        best = {at.x + step.dx, at.y + step.dy};
      }
      if (best_slope <= 0) break;
      path.push_back(best);
    }
    return path;
  }

  /// Shortest way among wide enough cells; ways off the diagram count kOffDiagram times their
  /// length, so that they only bridge gaps that cells leave in it.
  std::vector<Cell> along_diagram(const Cell& from, const Cell& to) const {
    constexpr double kOffDiagram = 10;
    const double kInfinity = std::numeric_limits<double>::infinity();
    std::vector<double> cost(cells_.cells().size(), kInfinity);
    std::vector<std::int8_t> came_by(cells_.cells().size(), -1);
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    cost[cells_.index(from.x, from.y)] = 0;
    queue.emplace(0, cells_.index(from.x, from.y));
    const std::size_t goal = cells_.index(to.x, to.y);
    while (!queue.empty() && queue.top().second != goal) {
      const auto [so_far, index] = queue.top();
      queue.pop();
      if (so_far > cost[index]) continue;
      const Cell at = cell_at(index);
      for (std::size_t s = 0; s < std::size(kSteps); ++s) {
        if (!may_step(at, kSteps[s])) continue;
        const Cell next{at.x + kSteps[s].dx, at.y + kSteps[s].dy};
        const double weight = is_on_diagram(next) ? 1 : kOffDiagram;
        const double total = so_far + weight * kSteps[s].length;
        const std::size_t n = cells_.index(next.x, next.y);
        if (total >= cost[n]) continue;
        cost[n] = total;
        came_by[n] = static_cast<std::int8_t>(s);
        queue.emplace(total, n);
      }
    }
    return backtrack(from, to, came_by);
  }

  Cell cell_at(std::size_t index) const {
    const auto width = static_cast<std::size_t>(cells_.size_x());
    return {static_cast<int>(index % width), static_cast<int>(index / width)};
  }

  std::vector<Cell> backtrack(const Cell& from, const Cell& to,
                              const std::vector<std::int8_t>& came_by) const {
    std::vector<Cell> path = {to};
    while (!same(path.back(), from)) {
      const Cell at = path.back();
      const std::int8_t s = came_by[cells_.index(at.x, at.y)];
      if (s < 0) return {};
      path.push_back({at.x - kSteps[s].dx, at.y - kSteps[s].dy});
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  /// Ascents from start and goal may run over the same cells; a cell is passed once.
  std::vector<Cell> without_loops(const std::vector<Cell>& path) const {
    std::vector<int> seen_at(cells_.cells().size(), -1);
    std::vector<Cell> result;
    for (const Cell& c : path) {
      int& seen = seen_at[cells_.index(c.x, c.y)];
      if (seen >= 0) {
        for (std::size_t i = static_cast<std::size_t>(seen) + 1; i < result.size(); ++i)
          seen_at[cells_.index(result[i].x, result[i].y)] = -1;
        result.resize(static_cast<std::size_t>(seen) + 1);
      } else {
        seen = static_cast<int>(result.size());
        result.push_back(c);
      }
    }
    return result;
  }

  const Occupancy& cells_;
  const DistanceField& field_;
  double least_;
  Cell source_, target_;
};

}  // namespace

std::optional<SafestPath> safest_path(const PlanningProblem& problem, std::string& reason) {
  const double bottleneck = widest_bottleneck(problem.world, problem.start, problem.goal);
  if (bottleneck < problem.robot_radius) {
    reason = "no path from start to goal is wide enough for the robot";
    return std::nullopt;
  }
  const std::vector<Cell> cells = SafestSearch(problem, bottleneck).run();
  const Occupancy& occupancy = problem.world.occupancy();
  SafestPath result;
  result.bottleneck = bottleneck;
  result.path.push_back(problem.start);
  for (std::size_t i = 1; i + 1 < cells.size(); ++i)
    result.path.push_back(occupancy.cell_center(cells[i].x, cells[i].y));
  result.path.push_back(problem.goal);
  return result;
}

}  // namespace slalom
