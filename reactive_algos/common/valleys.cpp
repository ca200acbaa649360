#include "common/valleys.h"

#include <algorithm>

namespace reactive {
namespace {

/// Whether a gap lies between sector k and the next: a jump of the way, or the end of what is open.
bool gap_after(const Sectors& sectors, std::size_t k, double gap, double passable) {
  const double here = sectors.ways[k], next = sectors.ways[(k + 1) % sectors.count()];
  return std::abs(next - here) > gap || (here < passable) != (next < passable);
}

/// The direction of the valley's end that the target is nearer to, of those that rise.
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
    if (sectors.nearest() >= passable) valleys.push_back({{-kPi, 2 * kPi}, true, true});
    return valleys;
  }
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const std::size_t before = gaps[i], last = gaps[(i + 1) % gaps.size()];
    const SectorRun run{(before + 1) % n, (last + n - before - 1) % n + 1};
    if (sectors.ways[run.first] < passable) continue;
    const bool rises_low = sectors.ways[run.first] > sectors.ways[before];
    const bool rises_high = sectors.ways[last] > sectors.ways[(last + 1) % n];
    if (rises_low || rises_high)
      valleys.push_back({opening_of(sectors, run), rises_low, rises_high});
  }
  return valleys;
}

Choice choose_valley(const std::vector<Valley>& valleys, const Sectors& sectors,
                     const Point& target, double horizon) {
  const double direction = std::atan2(target.y, target.x);
  const double left = std::hypot(target.x, target.y);
  Choice best;
  double nearest = HUGE_VAL;
  for (const Valley& valley : valleys) {
    bool low = false;
    double away = end_distance(valley, direction, low);
    const bool holds =
        valley.span.contains(direction) && sectors.way(direction) >= std::min(horizon, 0.95 * left);
    if (holds) away = -1;
    if (away >= nearest) continue;
    nearest = away;
    best = {&valley, holds, low};
  }
  return best;
}

}  // namespace reactive
