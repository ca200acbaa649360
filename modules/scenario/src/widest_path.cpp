#include <slalom/scenario/widest_path.h>

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Cells ordered by the bottleneck of the best path to them, widest first. Cells that do not reduce
/// the bottleneck need no ordering: they are kept on a stack.
class Frontier {
 public:
  void push(double bottleneck, double current, std::size_t cell) {
    if (bottleneck >= current)
      level_.push_back(cell);
    else
      narrower_.emplace(bottleneck, cell);
  }

  bool empty() const { return level_.empty() && narrower_.empty(); }

  /// Takes the next cell; `current` becomes its bottleneck.
  std::size_t pop(double& current) {
    std::size_t cell = 0;
    if (!level_.empty()) {
      cell = level_.back();
      level_.pop_back();
    } else {
      current = narrower_.top().first;
      cell = narrower_.top().second;
      narrower_.pop();
    }
    return cell;
  }

 private:
  std::vector<std::size_t> level_;
  std::priority_queue<std::pair<double, std::size_t>> narrower_;
};

}  // namespace

double widest_bottleneck(const World& world, const TPoint2D& start, const TPoint2D& goal) {
  const Occupancy& cells = world.occupancy();
  const DistanceField& field = world.distance_field();
  const double limit = std::min(field.clearance(start), field.clearance(goal));
  if (limit == 0) return 0;
  const auto cell_of = [&](const TPoint2D& p) {
    const TPoint2D at = cells.to_cells(p);
    return cells.index(static_cast<int>(at.x), static_cast<int>(at.y));
  };
  const std::size_t source = cell_of(start), target = cell_of(goal);
  // A cell is settled with its best bottleneck when it is first reached, as in Prim's algorithm.
  std::vector<bool> reached(cells.cells().size(), false);
  Frontier frontier;
  double bottleneck = limit;
  reached[source] = true;
  frontier.push(limit, limit, source);
  while (!frontier.empty()) {
    const std::size_t cell = frontier.pop(bottleneck);
    if (cell == target) return bottleneck;
    const int x = static_cast<int>(cell % static_cast<std::size_t>(cells.size_x()));
    const int y = static_cast<int>(cell / static_cast<std::size_t>(cells.size_x()));
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if (cells.occupied(x + dx, y + dy)) continue;
        const std::size_t next = cells.index(x + dx, y + dy);
        if (reached[next] || cells.occupied(x + dx, y) || cells.occupied(x, y + dy)) continue;
        reached[next] = true;
        const double width = next == target ? limit : field.at_center(x + dx, y + dy);
        frontier.push(std::min(bottleneck, width), bottleneck, next);
      }
  }
  return 0;
}

}  // namespace slalom
