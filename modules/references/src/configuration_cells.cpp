#include "configuration_cells.h"
#include "contact.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// Subcells [first, last) of a row that are occupied.
struct Run {
  int first = 0, last = 0;
};

/// The subcells that one occupied subcell blocks: the reach to both sides of it in the rows 0, 1,
/// 2, ... above and below. -1 if none.
using Stencil = std::vector<int>;

/// Blocks (dx, dy) when the distance of the offset (max(|dx| - slack, 0), max(|dy| - slack, 0)) is
/// below `radius` (all in subcells).
Stencil make_stencil(double radius, int slack) {
  Stencil reach;
  for (int dy = 0;; ++dy) {
    const double across = std::max(dy - slack, 0);
    if (across >= radius) return reach;
    int dx = static_cast<int>(std::sqrt(radius * radius - across * across));
    while (std::hypot(dx, across) >= radius) --dx;  // strictly below
    reach.push_back(dx + slack);
  }
}

/// The occupied runs of each row of subcells, including the border outside the grid.
class OccupiedRows {
 public:
  OccupiedRows(const Occupancy& cells, int subdivision)
      : subdivision_(subdivision), rows_(static_cast<std::size_t>(cells.size_y())) {
    const int width = cells.size_x() * subdivision;
    outside_ = {{-1, width + 1}};
    for (int cy = 0; cy < cells.size_y(); ++cy) {
      std::vector<Run>& runs = rows_[static_cast<std::size_t>(cy)];
      runs.push_back({-1, 0});
      for (int cx = 0; cx < cells.size_x(); ++cx) {
        if (!cells.occupied(cx, cy)) continue;
        if (runs.back().last < cx * subdivision) runs.push_back({cx * subdivision, 0});
        runs.back().last = (cx + 1) * subdivision;
      }
      if (runs.back().last < width) runs.push_back({width, 0});
      runs.back().last = width + 1;
    }
  }

  const std::vector<Run>& at(int sy) const {
    const bool inside = sy >= 0 && sy < static_cast<int>(rows_.size()) * subdivision_;
    return inside ? rows_[static_cast<std::size_t>(sy / subdivision_)] : outside_;
  }

 private:
  int subdivision_;
  std::vector<std::vector<Run>> rows_;
  std::vector<Run> outside_;
};

/// Blocks the subcells within the stencil of any occupied subcell. Runs are widened and counted at
/// their ends, so the cost grows with the perimeter of obstacles, not with their area.
CellGrid dilate(const OccupiedRows& occupied, int size_x, int size_y, const Stencil& stencil) {
  CellGrid grid{size_x, size_y, {}};
  grid.blocked.resize(static_cast<std::size_t>(size_x) * static_cast<std::size_t>(size_y));
  const int reach = static_cast<int>(stencil.size()) - 1;
  std::vector<int> change(static_cast<std::size_t>(size_x) + 1);
  for (int sy = 0; sy < size_y; ++sy) {
    std::fill(change.begin(), change.end(), 0);
    for (int dy = -reach; dy <= reach; ++dy) {
      const int side = stencil[static_cast<std::size_t>(std::abs(dy))];
      for (const Run& run : occupied.at(sy + dy)) {
        ++change[static_cast<std::size_t>(std::clamp(run.first - side, 0, size_x))];
        --change[static_cast<std::size_t>(std::clamp(run.last + side, 0, size_x))];
      }
    }
    std::uint8_t* row = grid.blocked.data() + static_cast<std::size_t>(sy) * size_x;
    int depth = 0;
    for (int sx = 0; sx < size_x; ++sx) {
      depth += change[static_cast<std::size_t>(sx)];
      row[sx] = depth > 0 ? 1 : 0;
    }
  }
  return grid;
}

}  // namespace

ConfigurationCells make_configuration_cells(const Occupancy& occupancy, double robot_radius,
                                            int subdivision) {
  ConfigurationCells result;
  result.cell_size = occupancy.resolution() / subdivision;
  const double radius = robot_radius / result.cell_size;
  const double tolerated = std::max(radius - kContactTolerance / result.cell_size, 1e-12);
  // The maximum distance of a point of a closed square to another square at offset (dx, dy) is
  // |(dx, dy)|. The tolerance of collision checking must stay within the bound.
  const Stencil outer = make_stencil(tolerated, 0);
  // The minimum distance is the gap between both squares.
  const Stencil inner = make_stencil(radius, 1);
  const int size_x = occupancy.size_x() * subdivision, size_y = occupancy.size_y() * subdivision;
  const OccupiedRows occupied(occupancy, subdivision);
  result.outer = dilate(occupied, size_x, size_y, outer);
  result.inner = dilate(occupied, size_x, size_y, inner);
  return result;
}

}  // namespace slalom
