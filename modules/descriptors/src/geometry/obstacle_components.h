#pragma once

#include <slalom/scenario/occupancy.h>

#include <vector>

namespace slalom {

/// A connected component (8-neighborhood) of occupied cells.
struct ObstacleComponent {
  std::size_t cells = 0;
  bool touches_border = false;
};

std::vector<ObstacleComponent> obstacle_components(const Occupancy& cells);

}  // namespace slalom
