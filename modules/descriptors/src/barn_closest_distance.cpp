#include "barn_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

/// Distance between the centres of a cell and of the nearest obstacle cell (cells): in growing
/// squares about the cell, until none can be nearer.
std::optional<double> distance_to_obstacle(const BarnField& field, int row, int column) {
  double best = std::numeric_limits<double>::infinity();
  const int most = std::max(field.rows(), field.columns());
  for (int ring = 0; ring <= most && ring < best; ++ring)
    for (int dr = -ring; dr <= ring; ++dr) {
      const bool whole_line = std::abs(dr) == ring;
      for (int dc = -ring; dc <= ring; dc += whole_line || ring == 0 ? 1 : 2 * ring)
        if (field.inside(row + dr, column + dc) && field.blocked(row + dr, column + dc))
          best = std::min(best, std::hypot(dr, dc));
    }
  return std::isinf(best) ? std::nullopt : std::make_optional(best);
}

/// BARN's distance to the closest obstacle.
class BarnClosestDistance : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"barn_closest_distance", 1, "BARN: distance to closest obstacle", "cells",
            Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return barn_parameters(context);
  }

  Value compute(const DescriptorContext& context) const override {
    const BarnField field(context);
    return field.mean([&](int r, int c) { return distance_to_obstacle(field, r, c); },
                      "no obstacles");
  }
};

}  // namespace

DescriptorPtr make_barn_closest_distance() {
  return std::make_shared<BarnClosestDistance>();
}

}  // namespace slalom
