#include "descriptors.h"
#include "obstacle_components.h"

#include <algorithm>

namespace slalom {
namespace {

/// Components of O that do not touch the border; cells that share a corner hang together.
class ObstacleCount : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"obstacle_count", 1, "Obstacle components", "count", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return resolution_parameter(context.world);
  }

  Value compute(const DescriptorContext& context) const override {
    const auto components = obstacle_components(context.world.occupancy());
    return Value::of(static_cast<double>(std::count_if(
        components.begin(), components.end(),
        [](const ObstacleComponent& component) { return !component.touches_border; })));
  }
};

}  // namespace

DescriptorPtr make_obstacle_count() {
  return std::make_shared<ObstacleCount>();
}

}  // namespace slalom
