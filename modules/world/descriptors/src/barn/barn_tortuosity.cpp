// SPDX-License-Identifier: BSD-3-Clause
#include "barn_field.h"

#include <slalom/core/distance.h>

namespace slalom::descriptors {

/// BARN's tortuosity: length of the path / distance between its end points.
Value barn_tortuosity(const DescriptorContext& context) {
  const auto& path = barn_path(context);
  if (path.empty()) return Value::na(context.shortest().reason);
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += distance_between(path[i], path[i - 1]);
  const double straight = distance_between(path.back(), path.front());
  if (straight <= 0) return Value::na("start and end of the path coincide");
  return Value::of(length / straight);
}

}  // namespace slalom::descriptors
