// SPDX-License-Identifier: BSD-3-Clause
#include "barn_field.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom::descriptors {
namespace {

/// Distance between the centers of a cell and of the nearest obstacle cell (cells), searched in
/// growing squares around the cell until no cell can be closer.
std::optional<double> distance_to_obstacle(const BarnField& field, int row, int column) {
  double best = std::numeric_limits<double>::infinity();
  const int max_ring = std::max(field.rows(), field.columns());
  for (int ring = 0; ring <= max_ring && ring < best; ++ring)
    for (int dr = -ring; dr <= ring; ++dr) {
      const bool whole_line = std::abs(dr) == ring;
      for (int dc = -ring; dc <= ring; dc += whole_line || ring == 0 ? 1 : 2 * ring)
        if (field.inside(row + dr, column + dc) && field.blocked(row + dr, column + dc))
          best = std::min(best, math::hypot(dr, dc));
    }
  return std::isinf(best) ? std::nullopt : std::make_optional(best);
}

}  // namespace

/// BARN's distance to the closest obstacle.
Value barn_closest_distance(const DescriptorContext& context) {
  const BarnField& field = barn_field(context);
  return field.mean([&](int r, int c) { return distance_to_obstacle(field, r, c); },
                    "no obstacles");
}

}  // namespace slalom::descriptors
