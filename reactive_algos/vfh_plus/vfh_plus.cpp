// SPDX-License-Identifier: BSD-3-Clause
#include "vfh_plus/vfh_plus.h"

#include <slalom/core/math.h>

#include <algorithm>

namespace vfh_plus {

using namespace reactive;

void Parameters::visit(slalom::OptionVisitor& v) {
  using slalom::Range;
  v.option("window", window, "length", "radius of the active window", Range::at_least(1e-3));
  v.option("threshold_high", threshold_high, "-", "tau_high: a sector above is blocked, Eq. (8)",
           Range::between(0, 1));
  v.option("threshold_low", threshold_low, "-", "tau_low: a sector below is free",
           Range::between(0, 1));
  v.option("wide_opening", wide_opening, "rad", "s_max: openings wider than this are wide",
           Range::between(0, 2 * M_PI));
  v.option("goal_weight", goal_weight, "-", "mu_1, Eq. (15)", Range::at_least(0));
  v.option("heading_weight", heading_weight, "-", "mu_2, weight of the current heading",
           Range::at_least(0));
  v.option("previous_weight", previous_weight, "-", "mu_3, weight of the previous direction",
           Range::at_least(0));
  v.option("slow_distance", slow_distance, "length",
           "below this free distance the robot slows down", Range::at_least(0));
  v.option("target_slow_down", target_slow_down, "m",
           "below this distance to the target the robot slows down", Range::at_least(0));
}

std::vector<double> primary_histogram(const Sectors& sectors, double window,
                                      double target_distance) {
  std::vector<double> result;
  for (const double free_distance : sectors.free_distances) {
    // Obstacles behind the target are ignored.
    const bool counts = free_distance < window && free_distance < target_distance;
    result.push_back(counts ? 1 - (free_distance / window) * (free_distance / window) : 0);
  }
  return result;
}

void update_binary(const std::vector<double>& primary, const Parameters& parameters,
                   std::vector<char>& blocked) {
  blocked.resize(primary.size(), 0);
  for (std::size_t k = 0; k < primary.size(); ++k) {
    if (primary[k] > parameters.threshold_high) blocked[k] = 1;
    if (primary[k] < parameters.threshold_low) blocked[k] = 0;
  }
}

std::vector<double> candidates(const Opening& opening, double target_direction,
                               double wide_opening) {
  if (opening.width >= 2 * M_PI - 1e-9) return {target_direction};
  if (opening.width < wide_opening) return {opening.middle()};
  std::vector<double> result = {wrapped(opening.low + 0.5 * wide_opening),
                                wrapped(opening.high() - 0.5 * wide_opening)};
  const double between = std::abs(wrapped(target_direction - opening.middle()));
  if (between < 0.5 * (opening.width - wide_opening)) result.push_back(target_direction);
  return result;
}

double VfhPlus::cost(double candidate, double target_direction) const {
  return parameters.goal_weight * std::abs(wrapped(candidate - target_direction)) +
         parameters.heading_weight * std::abs(candidate) +
         parameters.previous_weight * std::abs(wrapped(candidate - previous_));
}

Decision VfhPlus::decide(const Sectors& sectors, const Point& target) {
  const double target_direction = slalom::math::atan2(target.y, target.x);
  const double target_distance = slalom::math::hypot(target.x, target.y);
  update_binary(primary_histogram(sectors, parameters.window, target_distance), parameters,
                blocked_);
  Sectors binary{std::vector<double>(sectors.count()), 1};
  for (std::size_t k = 0; k < sectors.count(); ++k)
    binary.free_distances[k] = blocked_[k] != 0 ? 0 : 1;
  double best = previous_, best_cost = HUGE_VAL;
  for (const SectorRun& run : open_runs(binary, 0.5))
    for (const double candidate :
         candidates(opening_of(sectors, run), target_direction, parameters.wide_opening)) {
      const double value = cost(candidate, target_direction);
      if (value >= best_cost) continue;
      best_cost = value;
      best = candidate;
    }
  if (best_cost == HUGE_VAL) return search_.next(target_direction);
  search_.reset();
  previous_ = best;
  const double free_distance =
      std::min(sectors.free_distance(best), sectors.free_distance(0.5 * best));
  return {best, speed_fraction(free_distance, target_distance, parameters.slow_distance,
                               parameters.target_slow_down * sectors.meter)};
}

}  // namespace vfh_plus
