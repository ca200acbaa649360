// SPDX-License-Identifier: BSD-3-Clause
#include "configuration_space.h"

namespace slalom::descriptors {

/// Mean of d over F_C.
Value clearance_mean(const DescriptorContext& context) {
  const SharedArray<float>& distances = context.world.distance_field().centers();
  const FreeHeadings space = free_headings(context);
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    sum += space.free[i] * static_cast<double>(distances[i]);
    count += space.free[i];
  }
  if (count == 0) return Value::na("no collision-free configuration");
  return Value::of(sum / count);
}

}  // namespace slalom::descriptors
