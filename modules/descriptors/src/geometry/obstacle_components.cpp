#include "obstacle_components.h"

#include <utility>

namespace slalom {
namespace {

/// Flood fill from the cells on the stack; clears the visited cells in `remaining`.
ObstacleComponent extract_component(const Occupancy& cells, std::vector<std::uint8_t>& remaining,
                                    std::vector<std::pair<int, int>>& stack) {
  ObstacleComponent component;
  while (!stack.empty()) {
    const auto [x, y] = stack.back();
    stack.pop_back();
    ++component.cells;
    if (x == 0 || y == 0 || x == cells.size_x() - 1 || y == cells.size_y() - 1)
      component.touches_border = true;
    for (int next_y = y - 1; next_y <= y + 1; ++next_y)
      for (int next_x = x - 1; next_x <= x + 1; ++next_x) {
        if (!cells.inside(next_x, next_y) || remaining[cells.index(next_x, next_y)] == 0) continue;
        remaining[cells.index(next_x, next_y)] = 0;
        stack.emplace_back(next_x, next_y);
      }
  }
  return component;
}

}  // namespace

std::vector<ObstacleComponent> obstacle_components(const Occupancy& cells) {
  std::vector<std::uint8_t> remaining = cells.cells();
  std::vector<std::pair<int, int>> stack;
  std::vector<ObstacleComponent> components;
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x) {
      if (remaining[cells.index(x, y)] == 0) continue;
      remaining[cells.index(x, y)] = 0;
      stack.emplace_back(x, y);
      components.push_back(extract_component(cells, remaining, stack));
    }
  return components;
}

}  // namespace slalom
