#include "sectors.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

std::vector<mrpt::math::TPoint2D> obstacle_points(const mrpt::obs::CObservation2DRangeScan& scan) {
  const std::size_t count = scan.getScanSize();
  std::vector<mrpt::math::TPoint2D> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!scan.getScanRangeValidity(i)) continue;
    const double share = count < 2 ? 0.5 : static_cast<double>(i) / static_cast<double>(count - 1);
    const double angle = scan.aperture * (share - 0.5);
    const double range = scan.getScanRange(i);
    points.emplace_back(range * std::cos(angle), range * std::sin(angle));
  }
  return points;
}

double free_travel(const std::vector<mrpt::math::TPoint2D>& points, double direction, double radius,
                   double limit) {
  const double ux = std::cos(direction), uy = std::sin(direction);
  double way = limit;
  for (const auto& p : points) {
    const double along = p.x * ux + p.y * uy;
    const double aside = p.x * uy - p.y * ux;
    if (along <= 0 || std::abs(aside) >= radius) continue;
    way = std::min(way, along - std::sqrt(radius * radius - aside * aside));
  }
  return std::max(0.0, way);
}

double sector_direction(std::size_t k, std::size_t n) {
  return kPi * (-1 + 2 * (static_cast<double>(k) + 0.5) / static_cast<double>(n));
}

}  // namespace slalom
