// SPDX-License-Identifier: BSD-3-Clause
#include "common/valleys.h"

#include <slalom/core/math.h>

#include <algorithm>

namespace reactive {
namespace {

/// Whether there is a gap between sector k and the next: a discontinuity of the free distance, or a
/// transition between passable and impassable.
bool gap_after(const Sectors& sectors, std::size_t k, double gap, double passable) {
  const double here = sectors.free_distances[k],
               next = sectors.free_distances[(k + 1) % sectors.count()];
  return std::abs(next - here) > gap || (here < passable) != (next < passable);
}

/// Whether the free distance rises to sector k from its neighbor. The border of what is seen is the
/// end of an obstacle that closes only with a discontinuity, as it would be inside.
bool rises(const Sectors& sectors, std::size_t neighbor, std::size_t k, double gap,
           double passable) {
  const double there = sectors.free_distances[neighbor];
  return sectors.free_distances[k] > (there == Sectors::kUnseen ? passable + gap : there);
}

/// Angle between the target and the closest rising end of the valley.
double end_distance(const Valley& valley, double target, bool& low) {
  const double at_low = valley.rises_low ? std::abs(wrapped(valley.span.low - target)) : HUGE_VAL;
  const double at_high =
      valley.rises_high ? std::abs(wrapped(valley.span.high() - target)) : HUGE_VAL;
  low = at_low < at_high;
  return std::min(at_low, at_high);
}

}  // namespace

std::vector<Valley> find_valleys(const Sectors& sectors, double gap, double passable) {
  const std::size_t n = sectors.count();
  std::vector<std::size_t> gaps;
  for (std::size_t k = 0; k < n; ++k)
    if (gap_after(sectors, k, gap, passable)) gaps.push_back(k);
  std::vector<Valley> valleys;
  if (gaps.empty()) {
    if (sectors.min_free_distance() >= passable) valleys.push_back({{-M_PI, 2 * M_PI}, true, true});
    return valleys;
  }
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const std::size_t before = gaps[i], last = gaps[(i + 1) % gaps.size()];
    const SectorRun run{(before + 1) % n, (last + n - before - 1) % n + 1};
    if (sectors.free_distances[run.first] < passable) continue;
    const bool rises_low = rises(sectors, before, run.first, gap, passable);
    const bool rises_high = rises(sectors, (last + 1) % n, last, gap, passable);
    if (rises_low || rises_high)
      valleys.push_back({opening_of(sectors, run), rises_low, rises_high});
  }
  return valleys;
}

Choice choose_valley(const std::vector<Valley>& valleys, const Sectors& sectors,
                     const Point& target, double horizon) {
  const double direction = slalom::math::atan2(target.y, target.x);
  const double target_distance = slalom::math::hypot(target.x, target.y);
  Choice best;
  double min_angle = HUGE_VAL;
  for (const Valley& valley : valleys) {
    bool low = false;
    double away = end_distance(valley, direction, low);
    const bool contains_target =
        valley.span.contains(direction) &&
        sectors.free_distance(direction) >= std::min(horizon, 0.95 * target_distance);
    if (contains_target) away = -1;
    if (away >= min_angle) continue;
    min_angle = away;
    best = {&valley, contains_target, low};
  }
  return best;
}

}  // namespace reactive
