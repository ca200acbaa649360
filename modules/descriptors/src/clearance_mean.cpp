#include "configuration_space.h"
#include "descriptors.h"

namespace slalom {
namespace {

/// Mean of d over F_C.
class ClearanceMean : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"clearance_mean", 1, "Mean clearance", "m", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({robot_parameter(context), resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    const std::vector<float>& distances = context.world.distance_field().centers();
    const FreeHeadings space = free_headings(context);
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
      sum += space.free[i] * static_cast<double>(distances[i]);
      count += space.free[i];
    }
    if (count == 0) return Value::na("the robot stands free nowhere");
    return Value::of(sum / count);
  }
};

}  // namespace

DescriptorPtr make_clearance_mean() {
  return std::make_shared<ClearanceMean>();
}

}  // namespace slalom
