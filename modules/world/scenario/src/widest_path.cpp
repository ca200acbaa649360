// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/scenario/widest_path.h>

#include <algorithm>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

struct GridIndex {
  int x, y;
  bool operator==(const GridIndex& other) const { return x == other.x && y == other.y; }
};

/// Cells ordered by the bottleneck of the best path to them, widest first. Cells that do not reduce
/// the bottleneck need no ordering: they are kept on a stack.
class Frontier {
 public:
  /// A cell that does not reduce the bottleneck.
  void push_level(GridIndex cell) { level_.push_back(cell); }

  void push(float width, double current, GridIndex cell) {
    if (width >= current)
      push_level(cell);
    else
      narrower_.push({width, cell});
  }

  bool empty() const { return level_.empty() && narrower_.empty(); }

  /// Takes the next cell; `current` becomes its bottleneck.
  GridIndex pop(double& current) {
    GridIndex cell{};
    if (!level_.empty()) {
      cell = level_.back();
      level_.pop_back();
    } else {
      current = narrower_.top().width;
      cell = narrower_.top().cell;
      narrower_.pop();
    }
    return cell;
  }

 private:
  struct Narrower {
    float width;
    GridIndex cell;
    bool operator<(const Narrower& other) const { return width < other.width; }
  };
  std::vector<GridIndex> level_;
  std::priority_queue<Narrower> narrower_;
};

/// State of each cell, with a border of occupied cells: no step needs a test of bounds.
class Marks {
 public:
  Marks(const Occupancy& cells, const DistanceField& field, double limit)
      : stride_(static_cast<std::size_t>(cells.size_x()) + 2),
        marks_(stride_ * (static_cast<std::size_t>(cells.size_y()) + 2), kOccupied) {
    const auto size_x = static_cast<std::size_t>(cells.size_x());
    for (int y = 0; y < cells.size_y(); ++y) {
      const float* const d = field.centers().begin() + cells.index(0, y);
      const std::uint8_t* const occupied = cells.cells().data() + cells.index(0, y);
      std::uint8_t* const row = &marks_[index({0, y})];
      for (std::size_t x = 0; x < size_x; ++x)
        row[x] = occupied[x] != 0 ? kOccupied : double{d[x]} >= limit ? kWide : kNarrow;
    }
  }

  void reach(GridIndex cell) { marks_[index(cell)] = kReached; }

  /// Calls `reach(neighbor, wide)` for each free neighbor that was not reached and is not around an
  /// occupied corner, and marks it as reached; `wide`: d is at least the limit at its center.
  /// Neighbors towards `target` come last.
  template <typename Reach>
  void reach_neighbors(GridIndex cell, GridIndex target, const Reach& reach) {
    std::uint8_t* const here = &marks_[index(cell)];
    const int towards_x = target.x < cell.x ? -1 : 1, towards_y = target.y < cell.y ? -1 : 1;
    const auto stride = static_cast<std::ptrdiff_t>(stride_);
    for (int dy = -towards_y, i = 0; i < 3; ++i, dy += towards_y) {
      std::uint8_t* const row = here + dy * stride;
      if (row[-1] >= kReached && row[0] >= kReached && row[1] >= kReached) continue;
      for (int dx = -towards_x, j = 0; j < 3; ++j, dx += towards_x) {
        const std::uint8_t mark = row[dx];
        if (mark >= kReached || here[dx] == kOccupied || row[0] == kOccupied) continue;
        row[dx] = kReached;
        reach(GridIndex{cell.x + dx, cell.y + dy}, mark == kWide);
      }
    }
  }

 private:
  static constexpr std::uint8_t kWide = 0, kNarrow = 1, kReached = 2, kOccupied = 3;
  std::size_t index(GridIndex cell) const {
    return static_cast<std::size_t>(cell.y + 1) * stride_ + static_cast<std::size_t>(cell.x + 1);
  }
  std::size_t stride_;
  std::vector<std::uint8_t> marks_;
};

GridIndex cell_of(const Occupancy& cells, const TPoint2D& p) {
  const TPoint2D at = cells.to_cells(p);
  return {static_cast<int>(at.x), static_cast<int>(at.y)};
}

}  // namespace

bool has_bottleneck(const World& world, const TPoint2D& start, const TPoint2D& goal, double width) {
  const Occupancy& cells = world.occupancy();
  const DistanceField& field = world.distance_field();
  if (std::min(field.clearance(start), field.clearance(goal)) < width) return false;
  const GridIndex target = cell_of(cells, goal);
  Marks marks(cells, field, width);
  std::vector<GridIndex> open = {cell_of(cells, start)};
  marks.reach(open.front());
  while (!open.empty()) {
    const GridIndex cell = open.back();
    open.pop_back();
    if (cell == target) return true;
    marks.reach_neighbors(cell, target, [&](GridIndex next, bool wide) {
      if (wide || next == target) open.push_back(next);
    });
  }
  return false;
}

double widest_bottleneck(const World& world, const TPoint2D& start, const TPoint2D& goal) {
  const Occupancy& cells = world.occupancy();
  const DistanceField& field = world.distance_field();
  const double limit = std::min(field.clearance(start), field.clearance(goal));
  if (limit == 0) return 0;
  const GridIndex source = cell_of(cells, start), target = cell_of(cells, goal);
  // A cell is settled with its best bottleneck when it is first reached, as in Prim's algorithm.
  Marks marks(cells, field, limit);
  Frontier frontier;
  double bottleneck = limit;
  marks.reach(source);
  frontier.push_level(source);
  while (!frontier.empty()) {
    const GridIndex cell = frontier.pop(bottleneck);
    if (cell == target) return bottleneck;
    marks.reach_neighbors(cell, target, [&](GridIndex next, bool wide) {
      // The goal's clearance is that of its exact position, in `limit`.
      if (wide || next == target)
        frontier.push_level(next);
      else
        frontier.push(field.centers()[cells.index(next.x, next.y)], bottleneck, next);
    });
  }
  return 0;
}

}  // namespace slalom
