// SPDX-License-Identifier: BSD-3-Clause
#include "common/costmap.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace reactive {

std::uint8_t Inflation::cost(double distance) const {
  if (distance <= 0) return kLethal;
  if (distance <= inscribed_radius) return kInscribed;
  if (distance > inflation_radius) return kFree;
  const double factor = slalom::math::exp(-cost_scaling_factor * (distance - inscribed_radius));
  return static_cast<std::uint8_t>((kInscribed - 1) * factor);
}

Costmap::Costmap(double half_size, double resolution, const Inflation& inflation, double band)
    : inflation_(inflation),
      clearance_(
          half_size, resolution,
          std::max({band, inflation.inflation_radius, inflation.inscribed_radius}) + resolution) {
  const auto last = static_cast<std::size_t>(std::ceil(clearance_.band() * kPerMeter));
  for (std::size_t i = 0; i <= last + 1; ++i)
    costs_.push_back(inflation.cost(static_cast<double>(i) / static_cast<double>(kPerMeter)));
}

void Costmap::build(const Point& center, const std::vector<Point>& points) {
  const double r = clearance_.resolution();
  centers_.clear();
  for (const Point& p : points)
    centers_.push_back({(std::floor(p.x / r) + 0.5) * r, (std::floor(p.y / r) + 0.5) * r});
  clearance_.build(center, centers_);
}

std::uint8_t Costmap::cost(const Point& p) const {
  int x = 0, y = 0;
  return clearance_.cell_at(p, x, y) ? cost(x, y) : Inflation::kFree;
}

}  // namespace reactive
