// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/scenario/grid_map.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPoint2D;

/// Sets the members of setSize() directly.
class ExactGridMap : public COccupancyGridMap2D {
 public:
  ExactGridMap(int size_x, int size_y, double resolution, const TPoint2D& origin)
      : COccupancyGridMap2D(one_cell_map()) {
    m_size_x = static_cast<std::uint32_t>(size_x);
    m_size_y = static_cast<std::uint32_t>(size_y);
    m_resolution = static_cast<float>(resolution);
    m_xMin = static_cast<float>(origin.x);
    m_yMin = static_cast<float>(origin.y);
    m_xMax = static_cast<float>(origin.x + size_x * resolution);
    m_yMax = static_cast<float>(origin.y + size_y * resolution);
    m_map.assign(static_cast<std::size_t>(size_x) * m_size_y, p2l(1.0f));
    m_is_empty = false;
  }
};

}  // namespace

COccupancyGridMap2D one_cell_map() {
  return COccupancyGridMap2D(0, 1, 0, 1, 1);
}

COccupancyGridMap2D make_grid_map(int size_x, int size_y, double resolution,
                                  const TPoint2D& origin) {
  const bool good =
      size_x > 0 && size_y > 0 && static_cast<double>(size_x) * size_y <= kMaxGridCells &&
      static_cast<float>(resolution) > 0 && std::isfinite(static_cast<float>(resolution)) &&
      std::isfinite(static_cast<float>(origin.x)) && std::isfinite(static_cast<float>(origin.y));
  if (!good) {
    std::ostringstream what;
    what << size_x << " x " << size_y << " cells of " << resolution << " m at (" << origin.x << ", "
         << origin.y << ')';
    throw usage_error("grid", what.str(), "1 to 400 million cells of finite size and position");
  }
  COccupancyGridMap2D map = one_cell_map();
  map.copyMapContentFrom(ExactGridMap(size_x, size_y, resolution, origin));
  return map;
}

void set_unknown_free(mrpt::maps::COccupancyGridMap2D& map) {
  using Map = mrpt::maps::COccupancyGridMap2D;
  for (unsigned y = 0; y < map.getSizeY(); ++y) {
    auto* row = map.getRow(static_cast<int>(y));
    std::replace(row, row + map.getSizeX(), Map::p2l(0.5F), Map::p2l(1.0F));
  }
}

}  // namespace slalom
