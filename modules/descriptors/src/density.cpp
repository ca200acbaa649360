#include "descriptors.h"

namespace slalom {
namespace {

/// area(O) / A on the occupancy's cells.
class Density : public Descriptor {
 public:
  QuantityInfo info() const override { return {"density", 1, "Density", "-", Direction::None}; }

  std::string parameters(const DescriptorContext& context) const override {
    return resolution_parameter(context.world);
  }

  Value compute(const DescriptorContext& context) const override {
    const Occupancy& cells = context.world.occupancy();
    return Value::of(static_cast<double>(cells.count_occupied()) /
                     static_cast<double>(cells.cells().size()));
  }
};

}  // namespace

DescriptorPtr make_density() {
  return std::make_shared<Density>();
}

}  // namespace slalom
