#include "descriptors.h"

namespace slalom {
namespace {

/// Mean of d over F: over the centres of free cells.
class ClearnessMeanDistance : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"clearness_mean_distance", 1, "Mean distance to obstacles", "m", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return resolution_parameter(context.world);
  }

  Value compute(const DescriptorContext& context) const override {
    const std::vector<std::uint8_t>& cells = context.world.occupancy().cells();
    const std::vector<float>& distances = context.world.distance_field().centers();
    double sum = 0;
    std::size_t free_cells = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i] != 0) continue;
      sum += static_cast<double>(distances[i]);
      ++free_cells;
    }
    if (free_cells == 0) return Value::na("no free space");
    return Value::of(sum / static_cast<double>(free_cells));
  }
};

}  // namespace

DescriptorPtr make_clearness_mean_distance() {
  return std::make_shared<ClearnessMeanDistance>();
}

}  // namespace slalom
