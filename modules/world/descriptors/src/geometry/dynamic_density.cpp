// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/descriptors/descriptor.h>

#include <cmath>

namespace slalom::descriptors {

/// Total area of moving obstacles / A: of all movers, whether or not they overlap, or are present
/// at the same time.
Value dynamic_density(const DescriptorContext& context) {
  const Scenario& scenario = context.world.scenario();
  double area = 0;
  for (const Mover& mover : scenario.movers()) area += M_PI * mover.radius * mover.radius;
  return Value::of(area / (scenario.bounds().width() * scenario.bounds().height()));
}

}  // namespace slalom::descriptors
