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
    const int x = from.x + step.dx, y = from.y + step.dy;
    return kind(x, y) >= Kind::Wide && kind(from.x, y) != Kind::Occupied &&
           kind(x, from.y) != Kind::Occupied;
  }
  bool contains(const GridCell& c) const { return kind(c.x, c.y) == Kind::Ridge; }

  /// The path of steepest ascent of d from a cell to the diagram, both ends included. It ends early
  /// at a local maximum.
  std::vector<GridCell> ascend(const GridCell& from) const;

  /// The shortest path over wide cells, where lengths off the diagram are weighted by
  /// kOffDiagramCost: it leaves the diagram only to bridge gaps between cells, or where the detour
  /// along the diagram is longer by that factor. Empty if there is none.
  std::vector<GridCell> shortest(const GridCell& from, const GridCell& to) const;
  static constexpr double kOffDiagramCost = 10;

 private:
  enum class Kind : std::uint8_t { Occupied, Narrow, Wide, Ridge };

  Kind kind(int x, int y) const { return kinds_[index(x, y)]; }
  /// With a border of occupied cells around the grid.
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y + 1) * stride_ + static_cast<std::size_t>(x + 1);
  }
  double d(int x, int y) const;

  const Occupancy& cells_;
  const DistanceField& field_;
  std::size_t stride_;
  std::vector<Kind> kinds_;
};

}  // namespace slalom
