// SPDX-License-Identifier: BSD-3-Clause
#include "configuration_space.h"

namespace slalom::descriptors {

/// 1 - area(F_C) / A: the fraction of cells (and headings) in which the robot is in collision.
Value cspace_density(const DescriptorContext& context) {
  const FreeHeadings space = free_headings(context);
  std::size_t free = 0;
  for (const std::uint8_t count : space.free) free += count;
  return Value::of(1 - static_cast<double>(free) /
                           (static_cast<double>(space.free.size()) * space.headings));
}

}  // namespace slalom::descriptors
