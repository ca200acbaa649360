#include "sectors.h"

#include <algorithm>
#include <cmath>

namespace slalom {

std::vector<mrpt::math::TPoint2D> obstacle_points(const mrpt::obs::CObservation2DRangeScan& scan) {
  const std::size_t count = scan.getScanSize();
  std::vector<mrpt::math::TPoint2D> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!scan.getScanRangeValidity(i)) continue;
    const double fraction =
        count < 2 ? 0.5 : static_cast<double>(i) / static_cast<double>(count - 1);
    const double angle = scan.aperture * (fraction - 0.5);
    const double range = scan.getScanRange(i);
    points.emplace_back(range * std::cos(angle), range * std::sin(angle));
  }
  return points;
}

double free_distance(const std::vector<mrpt::math::TPoint2D>& points, double direction,
                     double radius, double limit) {
  const double ux = std::cos(direction), uy = std::sin(direction);
  double distance = limit;
  for (const auto& p : points) {
    const double along = p.x * ux + p.y * uy;
    const double lateral = p.x * uy - p.y * ux;
    // Contact is not closer than radius before the point: most points need no root.
    if (along <= 0 || along - radius >= distance || std::abs(lateral) >= radius) continue;
    distance = std::min(distance, along - std::sqrt(radius * radius - lateral * lateral));
  }
  return std::max(0.0, distance);
}

double sector_direction(std::size_t k, std::size_t n) {
  return M_PI * (-1 + 2 * (static_cast<double>(k) + 0.5) / static_cast<double>(n));
}

}  // namespace slalom
