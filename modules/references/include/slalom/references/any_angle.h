#pragma once

#include <slalom/trajectory/path.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace slalom {

/// A grid of cells for path planning of a point. Row-major; 1 blocked, 0 free; outside is blocked.
struct CellGrid {
  int size_x = 0, size_y = 0;
  std::vector<std::uint8_t> blocked;
  bool is_blocked(int cx, int cy) const {
    return cx < 0 || cy < 0 || cx >= size_x || cy >= size_y ||
           blocked[static_cast<std::size_t>(cy) * size_x + cx] != 0;
  }
};

/// The exact shortest path of a point from `start` to `goal` (both in cell units, any real
/// position) through the closed free cells: it may touch borders and corners of blocked cells, but
/// does not pass between two blocked cells that touch at a corner. nullopt if none exists.
std::optional<Path> shortest_any_angle_path(const CellGrid& grid, const mrpt::math::TPoint2D& start,
                                            const mrpt::math::TPoint2D& goal);

}  // namespace slalom
