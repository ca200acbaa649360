#include "configuration_space.h"
#include "descriptors.h"

#include <algorithm>

namespace slalom {
namespace {

/// 5 % quantile of d over F_C: the smallest distance that at least 5 % of F_C do not exceed.
class ClearanceQ05 : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"clearance_q05", 1, "Clearance, 5 % quantile", "m", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({robot_parameter(context), resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    const std::vector<float>& distances = context.world.distance_field().centers();
    const FreeHeadings space = free_headings(context);
    std::vector<float> sample;
    sample.reserve(distances.size());
    for (std::size_t i = 0; i < distances.size(); ++i)
      for (int heading = 0; heading < space.free[i]; ++heading) sample.push_back(distances[i]);
    if (sample.empty()) return Value::na("the robot stands free nowhere");
    const std::size_t rank = (sample.size() + 19) / 20;  // counted from 1
    const auto quantile = sample.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(sample.begin(), quantile, sample.end());
    return Value::of(static_cast<double>(*quantile));
  }
};

}  // namespace

DescriptorPtr make_clearance_q05() {
  return std::make_shared<ClearanceQ05>();
}

}  // namespace slalom
