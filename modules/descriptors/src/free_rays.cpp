#include "free_rays.h"
#include "lattice.h"

#include <algorithm>
#include <cmath>

namespace slalom {

double mean_free_ray(const DescriptorContext& context, const Primitives& movers) {
  constexpr int kRays = 8;
  const Bounds bounds = context.world.occupancy().bounds();
  const double diagonal = std::hypot(bounds.width(), bounds.height());
  const RayCaster& rays = context.world.ray_caster();
  const auto points = lattice_points(context.world.occupancy());
  double sum = 0;
  for (const mrpt::math::TPoint2D& point : points)
    for (int i = 0; i < kRays; ++i) {
      const double angle = 2 * M_PI * i / kRays;
      double range = rays.cast(point, angle, diagonal);
      if (!movers.discs.empty())
        range = std::min(range, cast_ray(movers, bounds, point, angle, range));
      sum += range / kRays;
    }
  return sum / static_cast<double>(points.size()) / (2 * context.robot_radius());
}

}  // namespace slalom
