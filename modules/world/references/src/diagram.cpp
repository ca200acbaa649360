// SPDX-License-Identifier: BSD-3-Clause
#include "diagram.h"

#include <slalom/references/voronoi_diagram.h>

namespace slalom {
Diagram::Diagram(const World& world, double bottleneck, const GridCell (&ends)[2])
    : cells_(world.occupancy()),
      field_(world.distance_field()),
      stride_(static_cast<std::size_t>(cells_.size_x()) + 2),
      corners_clear_(bottleneck > 1.5 * cells_.resolution()),
      kinds_(stride_ * (static_cast<std::size_t>(cells_.size_y()) + 2), Kind::Occupied) {
  std::vector<std::uint8_t> ridge(static_cast<std::size_t>(cells_.size_x()));
  for (int y = 0; y < cells_.size_y(); ++y) {
    find_ridge(field_, cells_, y, ridge.data());
    const std::size_t first = cells_.index(0, y);
    Kind* const kinds = &kinds_[index(0, y)];
    for (std::size_t x = 0; x < ridge.size(); ++x) {
      const Kind wide = ridge[x] != 0 ? Kind::Ridge : Kind::Wide;
      const Kind free = field_.centers()[first + x] >= bottleneck ? wide : Kind::Narrow;
      kinds[x] = cells_.cells()[first + x] != 0 ? Kind::Occupied : free;
    }
  }
  for (const GridCell& end : ends)
    if (Kind& kind = kinds_[index(end.x, end.y)]; kind == Kind::Narrow) kind = Kind::Wide;
}

double Diagram::d(int x, int y) const {
  return cells_.inside(x, y) ? field_.at_center(x, y) : 0.0;
}

std::vector<GridCell> Diagram::ascend(const GridCell& from) const {
  std::vector<GridCell> path = {from};
  while (!contains(path.back())) {
    const GridCell at = path.back();
    double best_slope = 0;
    GridCell best = at;
    for (const Step& step : kSteps) {
      if (!may_step(at, step)) continue;
      const double slope = (d(at.x + step.dx, at.y + step.dy) - d(at.x, at.y)) / step.length;
      if (slope <= best_slope) continue;
      best_slope = slope;
      best = {at.x + step.dx, at.y + step.dy};
    }
    if (best == at) break;
    path.push_back(best);
  }
  return path;
}

}  // namespace slalom
