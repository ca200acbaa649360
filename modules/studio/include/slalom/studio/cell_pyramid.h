#pragma once

#include <slalom/scenario/geometry.h>
#include <slalom/scenario/occupancy.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// A square tile of one level of a pyramid.
struct CellTile {
  int level = 0, x = 0, y = 0;  ///< column from the left, row from below
  bool operator<(const CellTile& o) const {
    return level != o.level ? level < o.level : y != o.y ? y < o.y : x < o.x;
  }
  bool operator==(const CellTile& o) const { return level == o.level && x == o.x && y == o.y; }
};

/// A grid of values (0 to 255) and coarser copies of it, each of half the resolution, for drawing
/// grids of any size at any zoom in tiles, with about as many cells as pixels.
class CellPyramid {
 public:
  static constexpr int kTileSize = 256;  ///< width and height of a tile, cells

  /// How four cells are merged into one.
  enum class Merge {
    Mean,
    Emphasize,  ///< average of mean and maximum: thin walls stay visible when zoomed out
  };

  /// `values` are row-major from the lower left corner, as in `cells`.
  CellPyramid(const Occupancy& cells, std::vector<std::uint8_t> values, Merge merge);

  int levels() const { return static_cast<int>(levels_.size()); }
  int size_x(int level) const { return levels_[static_cast<std::size_t>(level)].size_x; }
  int size_y(int level) const { return levels_[static_cast<std::size_t>(level)].size_y; }
  /// The values of a row of cells, from the left.
  const std::uint8_t* row(int level, int cy) const {
    const Level& at = levels_[static_cast<std::size_t>(level)];
    return &at.values[static_cast<std::size_t>(cy) * static_cast<std::size_t>(at.size_x)];
  }
  std::uint8_t value(int level, int cx, int cy) const { return row(level, cy)[cx]; }

  /// The finest level whose cells are at least one pixel wide; the coarsest if there is none.
  int level_for(double pixels_per_meter) const;
  /// The visible tiles of a level, row by row.
  std::vector<CellTile> tiles_in(int level, const Bounds& visible) const;
  /// The extent of a tile (m); tiles at the upper and right border are cut off at the grid's end.
  Bounds bounds_of(const CellTile& tile) const;
  int tile_size_x(const CellTile& tile) const;
  int tile_size_y(const CellTile& tile) const;

 private:
  struct Level {
    int size_x = 0, size_y = 0;
    std::vector<std::uint8_t> values;
  };
  static Level downsample(const Level& fine, Merge merge);

  double resolution_;
  Bounds bounds_;
  std::vector<Level> levels_;
};

}  // namespace slalom
