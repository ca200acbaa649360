// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scenario.h"

#include <slalom/scenario/grid_map.h>

namespace slalom {

Scenario grid_scenario(const std::string& name, const Occupancy& cells,
                       const mrpt::math::TPose2D& start, const mrpt::math::TPoint2D& goal) {
  auto map = make_grid_map(cells.size_x(), cells.size_y(), cells.resolution(), cells.origin());
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx)
      if (cells.occupied(cx, cy)) map.setCell(cx, cy, 0.0F);
  return Scenario::grid(name, map, start, goal);
}

}  // namespace slalom
