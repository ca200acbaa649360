#include "descriptors.h"

namespace slalom {
namespace {

/// Total area of moving obstacles / A. Nothing in a scenario moves but the robot, so it is 0.
class DynamicDensity : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"dynamic_density", 1, "Moving-obstacle density", "-", Direction::None};
  }

  std::string parameters(const DescriptorContext&) const override { return ""; }

  Value compute(const DescriptorContext&) const override { return Value::of(0); }
};

}  // namespace

DescriptorPtr make_dynamic_density() {
  return std::make_shared<DynamicDensity>();
}

}  // namespace slalom
