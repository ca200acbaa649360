// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/simulation/mover_scan.h>

#include <algorithm>
#include <cmath>

namespace slalom {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

MoverScan::MoverScan(const Movers& movers, const ScanGeometry& geometry)
    : movers_(movers), geometry_(geometry) {
  if (movers.empty()) return;
  directions_.reserve(static_cast<std::size_t>(geometry.count));
  for (int i = 0; i < geometry.count; ++i)
    directions_.emplace_back(math::cos(geometry.angle(i)), math::sin(geometry.angle(i)));
}

void MoverScan::add_to(const TPose2D& pose, double t, float* ranges) const {
  if (movers_.empty()) return;
  const auto [sine, cosine] = math::sin_cos(pose.phi);
  for (const Mover& mover : movers_) {
    if (!mover.present(t)) continue;
    const TPoint2D to = mover.position(t) - TPoint2D(pose);
    const double reach = geometry_.max_range + mover.radius;
    if (to.x * to.x + to.y * to.y >= reach * reach) continue;
    add_disc({cosine * to.x + sine * to.y, cosine * to.y - sine * to.x}, mover.radius, ranges);
  }
}

/// A disc in the robot frame: of the rays only those that can hit it are tested.
void MoverScan::add_disc(const TPoint2D& center, double radius, float* ranges) const {
  const double distance = math::hypot(center.x, center.y);
  if (distance <= radius) {
    std::fill_n(ranges, geometry_.count, 0.0F);
    return;
  }
  const double bearing = math::atan2(center.y, center.x);
  const double half_width = math::asin(radius / distance);
  // A disc behind the robot may be hit at both ends of an aperture beyond half a turn.
  for (const double turn : {-2 * M_PI, 0.0, 2 * M_PI})
    add_rays(bearing + turn, half_width, center, radius, ranges);
}

void MoverScan::add_rays(double bearing, double half_width, const TPoint2D& center, double radius,
                         float* ranges) const {
  const double half_aperture = 0.5 * geometry_.aperture;
  if (bearing + half_width < -half_aperture - 1e-9 || bearing - half_width > half_aperture + 1e-9)
    return;
  const int last = geometry_.count - 1;
  int from = 0, to = last;
  if (last > 0 && geometry_.aperture > 0) {
    const double rays_per_radian = last / geometry_.aperture;
    const auto index = [&](double angle) { return (angle + half_aperture) * rays_per_radian; };
    from = std::max(0, static_cast<int>(std::floor(index(bearing - half_width))));
    to = std::min(last, static_cast<int>(std::ceil(index(bearing + half_width))));
  }
  for (int i = from; i <= to; ++i) {
    const TPoint2D& ray = directions_[static_cast<std::size_t>(i)];
    const double along = ray.x * center.x + ray.y * center.y;
    const double across = ray.x * center.y - ray.y * center.x;
    const double half_chord = radius * radius - across * across;
    if (along <= 0 || half_chord < 0) continue;
    const auto range = static_cast<float>(std::max(0.0, along - std::sqrt(half_chord)));
    ranges[i] = std::min(ranges[i], range);
  }
}

}  // namespace slalom
