// SPDX-License-Identifier: BSD-3-Clause
#include "free_rays.h"
#include "sample_lattice.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace slalom {

double mean_free_ray(const DescriptorContext& context, const Primitives& movers) {
  constexpr int kRays = 8;
  const Bounds bounds = context.world.occupancy().bounds();
  const double diagonal = math::hypot(bounds.width(), bounds.height());
  const RayCaster& rays = context.world.ray_caster();
  const auto points = lattice_points(context.world.occupancy());
  std::array<double, kRays> angles{};
  std::array<mrpt::math::TPoint2D, kRays> directions;
  for (std::size_t i = 0; i < kRays; ++i) {
    // Half a step from the axes and diagonals: along these a ray could run on a line between cells.
    angles[i] = 2 * M_PI * (static_cast<double>(i) + 0.5) / kRays;
    directions[i] = {math::cos(angles[i]), math::sin(angles[i])};
  }
  double sum = 0;
  for (const mrpt::math::TPoint2D& point : points)
    for (std::size_t i = 0; i < kRays; ++i) {
      double range = rays.cast(point, directions[i], diagonal);
      if (!movers.discs.empty())
        range = std::min(range, cast_ray(movers, bounds, point, angles[i], range));
      sum += range / kRays;
    }
  return sum / static_cast<double>(points.size()) / (2 * context.robot_radius());
}

}  // namespace slalom
