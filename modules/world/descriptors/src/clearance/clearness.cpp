// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/descriptors/descriptor.h>

#include <algorithm>

namespace slalom::descriptors {

/// (1/area F) integral over F of min(d(q), R)/R: the mean over the centers of free cells.
Value clearness(const DescriptorContext& context) {
  const std::vector<std::uint8_t>& cells = context.world.occupancy().cells();
  const SharedArray<float>& distances = context.world.distance_field().centers();
  const double range = context.sensor_range;
  double sum = 0;
  std::size_t free_cells = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] != 0) continue;
    sum += std::min(static_cast<double>(distances[i]), range);
    ++free_cells;
  }
  if (free_cells == 0) return Value::na("no free space");
  return Value::of(sum / (range * static_cast<double>(free_cells)));
}

}  // namespace slalom::descriptors
