// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/descriptors/descriptor.h>

namespace slalom::descriptors {

/// L* / |s - g|.
Value detour_ratio(const DescriptorContext& context) {
  const Scenario& scenario = context.world.scenario();
  const double straight = distance_between(scenario.goal(), scenario.start());
  if (straight <= 0) return Value::na("start and goal coincide");
  const KnownPath& shortest = context.shortest();
  if (shortest.path.empty()) return Value::na(shortest.reason);
  return Value::of(shortest.length / straight);
}

}  // namespace slalom::descriptors
