// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/descriptors/descriptor.h>
#include <slalom/scenario/widest_path.h>

namespace slalom::descriptors {

/// 2 * max over paths from start to goal of (min over the path of d); NA if the robot does not fit.
Value bottleneck_width(const DescriptorContext& context) {
  const Scenario& scenario = context.world.scenario();
  const double widest =
      context.bottleneck
          ? *context.bottleneck
          : widest_bottleneck(context.world, {scenario.start().x, scenario.start().y},
                              scenario.goal());
  if (widest < context.robot_radius()) return Value::na("unsolvable: narrower than the robot");
  return Value::of(2 * widest);
}

}  // namespace slalom::descriptors
