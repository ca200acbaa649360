// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/world.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// A cell of an occupancy (distinct from the Cell of analysis tables).
struct GridCell {
  int x = 0, y = 0;
  bool operator==(const GridCell& other) const { return x == other.x && y == other.y; }
};

/// One of the eight steps from a cell to a neighbor.
struct Step {
  int dx, dy;
  double length;  ///< cells
};

constexpr double kDiagonal = 1.4142135623730951;
constexpr Step kSteps[] = {{1, 0, 1},          {-1, 0, 1},         {0, 1, 1},
                           {0, -1, 1},         {1, 1, kDiagonal},  {1, -1, kDiagonal},
                           {-1, 1, kDiagonal}, {-1, -1, kDiagonal}};

/// The cells of an occupancy that a path of a given bottleneck may use, and which of them lie on
/// the generalized Voronoi diagram: the ridge of the distance field.
class Diagram {
 public:
  /// Cells are wide if d at their center is at least `bottleneck` (m); `ends` always are, as start
  /// and goal are tested at their exact positions.
  Diagram(const World& world, double bottleneck, const GridCell (&ends)[2]);

  /// From a wide cell to a wide cell, and not around an occupied corner.
  bool may_step(const GridCell& from, const Step& step) const {
    const std::size_t at = index(from.x, from.y);
    return kinds_[neighbor(at, step.dx, step.dy)] >= Kind::Wide && !cuts_corner(at, step);
  }
  bool contains(const GridCell& c) const { return kinds_[index(c.x, c.y)] == Kind::Ridge; }

  /// The path of steepest ascent of d from a cell to the diagram, both ends included. It ends early
  /// at a local maximum.
  std::vector<GridCell> ascend(const GridCell& from) const;

  /// The shortest path over wide cells, where lengths off the diagram are weighted by
  /// kOffDiagramCost: it leaves the diagram only to bridge gaps between cells, or where the detour
  /// along the diagram is longer by that factor. Ties are broken from `to` backwards: the path that
  /// comes from the cell with the largest d, then by the first of kSteps. Empty if there is none.
  std::vector<GridCell> shortest(const GridCell& from, const GridCell& to) const;
  static constexpr int kOffDiagramCost = 10;

 private:
  enum class Kind : std::uint8_t { Occupied, Narrow, Wide, Ridge };

  /// Costs, in multiples of 2^-24 cells, of the shortest paths from `from` to all cells on those to
  /// `to`; those of other cells are upper bounds.
  std::vector<std::int64_t> costs(const GridCell& from, const GridCell& to) const;
  GridCell predecessor(const GridCell& at, const std::vector<std::int64_t>& cost) const;
  /// With a border of occupied cells around the grid.
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y + 1) * stride_ + static_cast<std::size_t>(x + 1);
  }
  std::size_t neighbor(std::size_t at, int dx, int dy) const {
    return at + static_cast<std::size_t>(dy) * stride_ + static_cast<std::size_t>(dx);
  }
  bool cuts_corner(std::size_t from, const Step& step) const {
    if (corners_clear_) return false;
    return kinds_[neighbor(from, step.dx, 0)] == Kind::Occupied ||
           kinds_[neighbor(from, 0, step.dy)] == Kind::Occupied;
  }
  std::int64_t cost_of(const Step& step, std::size_t to) const;
  double d(int x, int y) const;

  const Occupancy& cells_;
  const DistanceField& field_;
  std::size_t stride_;
  /// No wide cell shares a side with an occupied one: d is half a cell at most at the center of
  /// those that do, and the positions of the ends are less than a cell from the centers of their
  /// cells.
  bool corners_clear_;
  std::vector<Kind> kinds_;
};

}  // namespace slalom
