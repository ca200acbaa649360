#pragma once

#include <slalom/scenario/occupancy.h>

#include <vector>

namespace slalom {

/// Occupied cells that hang together, corners included: closed squares.
struct ObstacleComponent {
  std::size_t cells = 0;
  bool touches_border = false;
};

std::vector<ObstacleComponent> obstacle_components(const Occupancy& cells);

}  // namespace slalom
