// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/generation/map_window.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

int cells_of(double length, double resolution, int max_cells) {
  const double cells = std::round(length / resolution);
  return length > 0 && cells < max_cells ? std::max(1, static_cast<int>(cells)) : max_cells;
}

}  // namespace

MapWindows::MapWindows(Occupancy map, const MapWindowOptions& options)
    : map_(std::move(map)),
      options_(options),
      columns_(cells_of(options.width, map_.resolution(), map_.size_x())),
      rows_(cells_of(options.height, map_.resolution(), map_.size_y())) {}

Occupancy MapWindows::draw(RandomEngine& engine) const {
  constexpr int kDraws = 100;
  const double cells = static_cast<double>(columns_) * rows_;
  Corner best = {0, 0};
  double min_deficit = 2;
  for (int i = 0; i < kDraws && min_deficit > 0; ++i) {
    const Corner corner = draw_corner(engine);
    const double occupied = count_occupied(corner) / cells;
    const double deficit =
        std::max({0.0, options_.min_free - (1 - occupied), options_.min_occupied - occupied});
    if (deficit >= min_deficit) continue;
    min_deficit = deficit;
    best = corner;
  }
  return cut(best);
}

MapWindows::Corner MapWindows::draw_corner(RandomEngine& engine) const {
  const int x = uniform_int(engine, 0, map_.size_x() - columns_);
  return {x, uniform_int(engine, 0, map_.size_y() - rows_)};
}

int MapWindows::count_occupied(const Corner& corner) const {
  int count = 0;
  for (int y = corner.y; y < corner.y + rows_; ++y) {
    const auto row = map_.cells().begin() + static_cast<std::ptrdiff_t>(map_.index(corner.x, y));
    count += static_cast<int>(std::count(row, row + columns_, std::uint8_t{1}));
  }
  return count;
}

Occupancy MapWindows::cut(const Corner& corner) const {
  Occupancy window(columns_, rows_, map_.resolution(), map_.to_world(corner.x, corner.y));
  for (int y = 0; y < rows_; ++y)
    for (int x = 0; x < columns_; ++x)
      if (map_.occupied(corner.x + x, corner.y + y)) window.set_occupied(x, y, true);
  return window;
}

void MapWindowOptions::visit(OptionVisitor& v) {
  v.option("map", map, "map file: MRPT gridmap or simplemap, ROS map YAML");
  v.option("width", width, "m", "width of the window, 0: of the map", Range::at_least(0));
  v.option("height", height, "m", "height of the window, 0: of the map", Range::at_least(0));
  v.option("min_free", min_free, "-", "minimum fraction of free cells in the window",
           Range::between(0, 1));
  v.option("min_occupied", min_occupied, "-", "minimum fraction of occupied cells in the window",
           Range::between(0, 1));
}

}  // namespace slalom
