#include <slalom/descriptors/descriptor.h>

#include <algorithm>
#include <cmath>

namespace slalom::descriptors {
namespace {

constexpr double kSpacing = 1;  ///< m
constexpr int kRays = 8;

/// Points `spacing` apart, centered in an interval, as many as fit; at least one.
std::vector<double> lattice_along(double low, double high, double spacing) {
  const double count = std::max(1.0, std::floor((high - low) / spacing * (1 + 1e-9)));
  std::vector<double> points;
  for (double i = 0; i < count; ++i)
    points.push_back(0.5 * (low + high) + (i - 0.5 * (count - 1)) * spacing);
  return points;
}

}  // namespace

/// Mean over a lattice of 1 m of the mean free length of 8 rays / the robot's width; 0 at lattice
/// points in or on an obstacle. As in AvoidBench (Yu, de Croon, De Wagter 2023).
Value traversability(const DescriptorContext& context) {
  const Bounds bounds = context.world.occupancy().bounds();
  const double spacing = std::max(kSpacing, context.world.occupancy().resolution());
  const double diagonal = std::hypot(bounds.width(), bounds.height());
  const RayCaster& rays = context.world.ray_caster();
  double sum = 0;
  std::size_t points = 0;
  for (const double y : lattice_along(bounds.y_min, bounds.y_max, spacing))
    for (const double x : lattice_along(bounds.x_min, bounds.x_max, spacing)) {
      for (int i = 0; i < kRays; ++i)
        sum += rays.cast({x, y}, 2 * M_PI * i / kRays, diagonal) / kRays;
      ++points;
    }
  return Value::of(sum / static_cast<double>(points) / (2 * context.robot_radius()));
}

}  // namespace slalom::descriptors
