#include "descriptors.h"

#include <slalom/scenario/widest_path.h>

namespace slalom {
namespace {

/// 2 max over paths from start to goal of the min over the path of d; NA where the robot does not
/// fit.
class BottleneckWidth : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"bottleneck_width", 1, "Bottleneck width", "m", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({robot_parameter(context), resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    const auto& start = context.world.scenario().start();
    const double widest =
        widest_bottleneck(context.world, {start.x, start.y}, context.world.scenario().goal());
    if (widest < context.robot_radius()) return Value::na("unsolvable: narrower than the robot");
    return Value::of(2 * widest);
  }
};

}  // namespace

DescriptorPtr make_bottleneck_width() {
  return std::make_shared<BottleneckWidth>();
}

}  // namespace slalom
