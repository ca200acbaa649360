#include "configuration_space.h"
#include "descriptors.h"

namespace slalom {
namespace {

/// 1 - area(F_C) / A: the share of cells (and headings) in which the robot does not stand free.
class CspaceDensity : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"cspace_density", 1, "Configuration-space density", "-", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({robot_parameter(context), resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    const FreeHeadings space = free_headings(context);
    std::size_t free = 0;
    for (const std::uint8_t count : space.free) free += count;
    return Value::of(1 - static_cast<double>(free) /
                             (static_cast<double>(space.free.size()) * space.headings));
  }
};

}  // namespace

DescriptorPtr make_cspace_density() {
  return std::make_shared<CspaceDensity>();
}

}  // namespace slalom
