#include "descriptors.h"

#include <cmath>

namespace slalom {
namespace {

/// Sum of |heading change| along P* / L*.
class TurnDensity : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"turn_density", 1, "Turn density", "rad/m", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({robot_parameter(context), resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    const KnownPath& shortest = context.shortest();
    if (shortest.path.empty()) return Value::na(shortest.reason);
    if (!(shortest.length > 0)) return Value::na("the start is the goal");
    double turned = 0;
    mrpt::math::TPoint2D before(0, 0);
    for (std::size_t i = 1; i < shortest.path.size(); ++i) {
      const mrpt::math::TPoint2D leg = shortest.path[i] - shortest.path[i - 1];
      if (!(leg.norm() > 0)) continue;
      turned += std::abs(
          std::atan2(before.x * leg.y - before.y * leg.x, before.x * leg.x + before.y * leg.y));
      before = leg;
    }
    return Value::of(turned / shortest.length);
  }
};

}  // namespace

DescriptorPtr make_turn_density() {
  return std::make_shared<TurnDensity>();
}

}  // namespace slalom
