// SPDX-License-Identifier: BSD-3-Clause
#include "common/sectors.h"

#include <algorithm>

namespace reactive {

std::size_t Sectors::sector_of(double direction) const {
  const double at = std::floor((wrapped(direction) + M_PI) / width());
  return std::min(static_cast<std::size_t>(std::max(0.0, at)), count() - 1);
}

double Sectors::min_free_distance() const {
  return *std::min_element(free_distances.begin(), free_distances.end());
}

Sectors Sectors::ahead(double field_of_view) const {
  Sectors result = *this;
  for (std::size_t k = 0; k < count(); ++k)
    if (std::abs(direction(k)) > 0.5 * field_of_view) result.free_distances[k] = kUnseen;
  return result;
}

Decision SearchTurn::next(double target_direction) {
  if (side_ == 0) side_ = target_direction >= 0 ? 1 : -1;
  return {side_ * 0.5 * M_PI, kMinSpeedFraction};
}

std::vector<SectorRun> open_runs(const Sectors& sectors, double open) {
  const std::size_t n = sectors.count();
  std::size_t closed = 0;
  while (closed < n && sectors.free_distances[closed] >= open) ++closed;
  if (closed == n) return {{0, n}};
  std::vector<SectorRun> runs;
  // Start at a closed sector, so that no run is split.
  for (std::size_t i = 1; i <= n; ++i) {
    if (sectors.free_distances[(closed + i) % n] < open) continue;
    const bool goes_on = i > 1 && sectors.free_distances[(closed + i - 1) % n] >= open;
    if (!goes_on) runs.push_back({(closed + i) % n, 0});
    ++runs.back().length;
  }
  return runs;
}

double Opening::nearest_to(double direction, double margin) const {
  if (width >= 2 * M_PI - 1e-9) return direction;
  const double limited_margin = std::min(margin, 0.5 * width);
  const double from_middle = wrapped(direction - middle());
  const double limit_angle = 0.5 * width - limited_margin;
  return wrapped(middle() + std::clamp(from_middle, -limit_angle, limit_angle));
}

bool Opening::contains(double direction) const {
  return std::abs(wrapped(direction - middle())) <= 0.5 * width + 1e-9 || width >= 2 * M_PI - 1e-9;
}

Opening opening_of(const Sectors& sectors, const SectorRun& run) {
  return {wrapped(sectors.direction(run.first) - 0.5 * sectors.width()),
          static_cast<double>(run.length) * sectors.width()};
}

double speed_fraction(double free_distance, double target_distance, double slow_distance,
                      double target_distance_slow) {
  const double before_obstacle = free_distance / std::max(1e-6, slow_distance);
  const double before_target = target_distance / std::max(1e-6, target_distance_slow);
  return std::clamp(std::min(before_obstacle, before_target), kMinSpeedFraction, 1.0);
}

}  // namespace reactive
