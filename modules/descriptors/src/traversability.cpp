#include "descriptors.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kSpacing = 1;  ///< m
constexpr int kRays = 8;

/// As many places as fit, `spacing` apart, in the middle of an interval; at least one.
std::vector<double> lattice_along(double low, double high, double spacing) {
  const double count = std::max(1.0, std::floor((high - low) / spacing * (1 + 1e-9)));
  std::vector<double> places;
  for (double i = 0; i < count; ++i)
    places.push_back(0.5 * (low + high) + (i - 0.5 * (count - 1)) * spacing);
  return places;
}

/// Mean over a lattice of 1 m of the mean length of 8 free rays / the robot's width; 0 at lattice
/// points in or on an obstacle. As in AvoidBench (Yu, de Croon, De Wagter 2023).
class Traversability : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"traversability", 1, "Traversability", "-", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({robot_parameter(context), resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    const Bounds bounds = context.world.occupancy().bounds();
    const double spacing = std::max(kSpacing, context.world.occupancy().resolution());
    const double longest = std::hypot(bounds.width(), bounds.height());
    const RayCaster& rays = context.world.ray_caster();
    double sum = 0;
    std::size_t places = 0;
    for (const double y : lattice_along(bounds.y_min, bounds.y_max, spacing))
      for (const double x : lattice_along(bounds.x_min, bounds.x_max, spacing)) {
        for (int i = 0; i < kRays; ++i)
          sum += rays.cast({x, y}, 6.283185307179586 * i / kRays, longest) / kRays;
        ++places;
      }
    return Value::of(sum / static_cast<double>(places) / (2 * context.robot_radius()));
  }
};

}  // namespace

DescriptorPtr make_traversability() {
  return std::make_shared<Traversability>();
}

}  // namespace slalom
