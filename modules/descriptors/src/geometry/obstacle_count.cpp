#include "obstacle_components.h"

#include <slalom/descriptors/descriptor.h>

#include <algorithm>

namespace slalom::descriptors {

/// Number of 8-connected components of O that do not touch the border.
Value obstacle_count(const DescriptorContext& context) {
  const auto components = obstacle_components(context.world.occupancy());
  return Value::of(static_cast<double>(
      std::count_if(components.begin(), components.end(),
                    [](const ObstacleComponent& component) { return !component.touches_border; })));
}

}  // namespace slalom::descriptors
