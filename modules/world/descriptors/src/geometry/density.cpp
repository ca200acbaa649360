// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/descriptors/descriptor.h>

namespace slalom::descriptors {

/// area(O) / A on the occupancy's cells.
Value density(const DescriptorContext& context) {
  const Occupancy& cells = context.world.occupancy();
  return Value::of(static_cast<double>(cells.count_occupied()) /
                   static_cast<double>(cells.cells().size()));
}

}  // namespace slalom::descriptors
