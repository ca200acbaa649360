#include "descriptors.h"

#include <cmath>

namespace slalom {
namespace {

/// L* / |s - g|.
class DetourRatio : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"detour_ratio", 1, "Detour ratio", "-", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({robot_parameter(context), resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    const Scenario& scenario = context.world.scenario();
    const double straight =
        std::hypot(scenario.goal().x - scenario.start().x, scenario.goal().y - scenario.start().y);
    if (straight <= 0) return Value::na("the start is the goal");
    const KnownPath& shortest = context.shortest();
    if (shortest.path.empty()) return Value::na(shortest.reason);
    return Value::of(shortest.length / straight);
  }
};

}  // namespace

DescriptorPtr make_detour_ratio() {
  return std::make_shared<DetourRatio>();
}

}  // namespace slalom
