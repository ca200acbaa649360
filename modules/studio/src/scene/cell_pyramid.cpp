#include <slalom/studio/cell_pyramid.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slalom {

CellPyramid::CellPyramid(const Occupancy& cells, std::vector<std::uint8_t> values, Merge merge)
    : resolution_(cells.resolution()), bounds_(cells.bounds()) {
  levels_.push_back({cells.size_x(), cells.size_y(), std::move(values)});
  while (std::max(levels_.back().size_x, levels_.back().size_y) > kTileSize)
    levels_.push_back(downsample(levels_.back(), merge));
}

/// The last cells of a row or column of odd length are merged with themselves.
CellPyramid::Level CellPyramid::downsample(const Level& fine, Merge merge) {
  Level result{(fine.size_x + 1) / 2, (fine.size_y + 1) / 2, {}};
  const auto across = static_cast<std::size_t>(fine.size_x);
  result.values.reserve(static_cast<std::size_t>(result.size_x) *
                        static_cast<std::size_t>(result.size_y));
  for (int y = 0; y < fine.size_y; y += 2) {
    const std::uint8_t* low = &fine.values[static_cast<std::size_t>(y) * across];
    const std::uint8_t* high = y + 1 < fine.size_y ? low + across : low;
    for (int x = 0; x < fine.size_x; x += 2) {
      const int right = std::min(x + 1, fine.size_x - 1);
      const int mean = (low[x] + low[right] + high[x] + high[right] + 2) / 4;
      const int max = std::max({low[x], low[right], high[x], high[right]});
      result.values.push_back(
          static_cast<std::uint8_t>(merge == Merge::Mean ? mean : (mean + max + 1) / 2));
    }
  }
  return result;
}

int CellPyramid::level_for(double pixels_per_meter) const {
  const double cell = resolution_ * pixels_per_meter;
  if (!(cell < 1)) return 0;
  // Minus 1e-6, so that rounding errors do not select the next level for exactly half a pixel.
  const int level = static_cast<int>(std::ceil(std::log2(1 / cell) - 1e-6));
  return std::min(level, levels() - 1);
}

std::vector<CellTile> CellPyramid::tiles_in(int level, const Bounds& visible) const {
  const double side = kTileSize * resolution_ * std::ldexp(1.0, level);
  const auto range = [side](double from, double to, double origin, int cells) {
    const int last = (cells - 1) / kTileSize;
    const double first_visible = std::floor((from - origin) / side);
    const double last_visible = std::floor((to - origin) / side);
    return std::pair(static_cast<int>(std::clamp(first_visible, 0.0, last + 1.0)),
                     static_cast<int>(std::clamp(last_visible, -1.0, static_cast<double>(last))));
  };
  const auto [left, right] = range(visible.x_min, visible.x_max, bounds_.x_min, size_x(level));
  const auto [low, high] = range(visible.y_min, visible.y_max, bounds_.y_min, size_y(level));
  std::vector<CellTile> tiles;
  for (int y = low; y <= high; ++y)
    for (int x = left; x <= right; ++x) tiles.push_back({level, x, y});
  return tiles;
}

int CellPyramid::tile_size_x(const CellTile& tile) const {
  return std::min(kTileSize, size_x(tile.level) - tile.x * kTileSize);
}

int CellPyramid::tile_size_y(const CellTile& tile) const {
  return std::min(kTileSize, size_y(tile.level) - tile.y * kTileSize);
}

Bounds CellPyramid::bounds_of(const CellTile& tile) const {
  const double cell = resolution_ * std::ldexp(1.0, tile.level);
  const double left = bounds_.x_min + tile.x * kTileSize * cell;
  const double low = bounds_.y_min + tile.y * kTileSize * cell;
  return {left, low, left + tile_size_x(tile) * cell, low + tile_size_y(tile) * cell};
}

}  // namespace slalom
