#pragma once

#include <slalom/gui/view_transform.h>
#include <slalom/scenario/occupancy.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// A square piece of one level of a pyramid.
struct CellTile {
  int level = 0, x = 0, y = 0;  ///< the piece number x (from the left) and y (from below)
  bool operator<(const CellTile& o) const {
    return level != o.level ? level < o.level : y != o.y ? y < o.y : x < o.x;
  }
  bool operator==(const CellTile& o) const { return level == o.level && x == o.x && y == o.y; }
};

/// A grid of values (0 to 255) and coarser copies of it, each of half as many cells in a row, for
/// drawing grids of any size at any zoom in tiles: what is drawn is about as many cells as pixels.
class CellPyramid {
 public:
  static constexpr int kTile = 256;  ///< cells in a row of a tile

  /// How four cells become one.
  enum class Merge {
    Mean,
    Emphasise,  ///< half their mean, half their largest: thin walls stay visible from afar
  };

  /// `values` are row-major from the lower left corner, as in `cells`.
  CellPyramid(const Occupancy& cells, std::vector<std::uint8_t> values, Merge merge);

  int levels() const { return static_cast<int>(levels_.size()); }
  int size_x(int level) const { return levels_[static_cast<std::size_t>(level)].size_x; }
  int size_y(int level) const { return levels_[static_cast<std::size_t>(level)].size_y; }
  /// The values of a row of cells from the left.
  const std::uint8_t* row(int level, int cy) const {
    const Level& at = levels_[static_cast<std::size_t>(level)];
    return &at.values[static_cast<std::size_t>(cy) * static_cast<std::size_t>(at.size_x)];
  }
  std::uint8_t value(int level, int cx, int cy) const { return row(level, cy)[cx]; }

  /// The finest level of which a cell is at least a pixel wide; the coarsest if there is none.
  int level_for(double pixels_per_metre) const;
  /// The tiles of a level that are seen, row by row.
  std::vector<CellTile> tiles_in(int level, const Bounds& visible) const;
  /// What a tile covers (m); those at the upper and right border are cut off where the grid ends.
  Bounds bounds_of(const CellTile& tile) const;
  int cells_across(const CellTile& tile) const;
  int cells_up(const CellTile& tile) const;

 private:
  struct Level {
    int size_x = 0, size_y = 0;
    std::vector<std::uint8_t> values;
  };
  static Level coarser(const Level& fine, Merge merge);

  double resolution_;
  Bounds bounds_;
  std::vector<Level> levels_;
};

}  // namespace slalom
