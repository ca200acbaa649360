// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/descriptors/descriptor.h>

namespace slalom::descriptors {

/// Mean of d over F, at the centers of free cells.
Value clearness_mean_distance(const DescriptorContext& context) {
  const std::vector<std::uint8_t>& cells = context.world.occupancy().cells();
  const SharedArray<float>& distances = context.world.distance_field().centers();
  double sum = 0;
  std::size_t free_cells = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] != 0) continue;
    sum += static_cast<double>(distances[i]);
    ++free_cells;
  }
  if (free_cells == 0) return Value::na("no free space");
  return Value::of(sum / static_cast<double>(free_cells));
}

}  // namespace slalom::descriptors
