#include "barn_field.h"

#include <cmath>

namespace slalom {
namespace {

/// BARN's tortuosity: length of the path / distance between its ends.
class BarnTortuosity : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"barn_tortuosity", 1, "BARN: tortuosity", "-", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return barn_parameters(context);
  }

  Value compute(const DescriptorContext& context) const override {
    const auto& path = barn_path(context);
    if (path.empty()) return Value::na(context.shortest().reason);
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
      length += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
    const double straight =
        std::hypot(path.back().x - path.front().x, path.back().y - path.front().y);
    if (straight <= 0) return Value::na("the path ends where it begins");
    return Value::of(length / straight);
  }
};

}  // namespace

DescriptorPtr make_barn_tortuosity() {
  return std::make_shared<BarnTortuosity>();
}

}  // namespace slalom
