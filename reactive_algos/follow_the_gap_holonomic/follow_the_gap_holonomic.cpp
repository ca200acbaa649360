// SPDX-License-Identifier: BSD-3-Clause
#include "follow_the_gap_holonomic/follow_the_gap_holonomic.h"

#include <slalom/core/math.h>

#include <algorithm>

namespace follow_the_gap_holonomic {

using namespace reactive;

void Parameters::visit(slalom::OptionVisitor& v) {
  using slalom::Range;
  v.option("alpha", alpha, "length", "weight of the gap against the goal, Eq. (8)",
           Range::at_least(0));
  v.option("look_ahead", look_ahead, "length", "obstacles beyond this distance do not close gaps",
           Range::at_least(1e-3));
  v.option("goal_weight", goal_weight, "-", "penalty of a gap: twice this per radian from the goal",
           Range::at_least(0));
  v.option("field_of_view", field_of_view, "rad", "gaps outside it are ignored",
           Range::between(0.1, 2 * M_PI));
  v.option("slow_distance", slow_distance, "length",
           "below this free distance the robot slows down", Range::at_least(0));
  v.option("target_slow_down", target_slow_down, "m",
           "below this distance to the target the robot slows down", Range::at_least(0));
}

double gap_center(const Sectors& sectors, const SectorRun& run) {
  const std::size_t n = sectors.count();
  const Opening opening = opening_of(sectors, run);
  // The midpoint between the obstacles is not at the middle angle if one is closer. For gaps of pi
  // or more the triangle does not exist.
  if (opening.width >= M_PI) return opening.middle();
  const double d1 = sectors.free_distances[(run.first + n - 1) % n];
  const double d2 = sectors.free_distances[(run.first + run.length) % n];
  const double low = opening.low, high = opening.high();
  const double x = d1 * slalom::math::cos(low) + d2 * slalom::math::cos(high);
  const double y = d1 * slalom::math::sin(low) + d2 * slalom::math::sin(high);
  return x * x + y * y < 1e-12 ? opening.middle() : slalom::math::atan2(y, x);
}

double final_direction(double gap_center, double goal, double nearest, double alpha) {
  const double weight = alpha / std::max(nearest, 1e-3);
  return wrapped(goal + weight / (weight + 1) * wrapped(gap_center - goal));
}

Decision FollowTheGap::decide(const Sectors& sectors, const Point& target) {
  const double goal = slalom::math::atan2(target.y, target.x);
  const double target_distance = slalom::math::hypot(target.x, target.y);
  const double open = std::min(parameters.look_ahead, target_distance);
  SectorRun best;
  double best_value = -HUGE_VAL;
  const Sectors seen = sectors.ahead(parameters.field_of_view);
  const auto runs = open_runs(seen, open);
  for (const SectorRun& run : runs) {
    const Opening opening = opening_of(sectors, run);
    const double away = std::abs(wrapped(opening.nearest_to(goal, 0) - goal));
    const double value = opening.width - 2 * parameters.goal_weight * away;
    if (value <= best_value) continue;
    best_value = value;
    best = run;
  }
  if (runs.empty()) return search_.next(goal);
  search_.reset();
  double nearest = HUGE_VAL;
  for (std::size_t k = 0; k < sectors.count(); ++k)
    if (std::abs(sectors.direction(k)) <= 0.5 * parameters.field_of_view)
      nearest = std::min(nearest, sectors.free_distances[k]);
  double direction = goal;
  if (nearest < open)
    direction = final_direction(gap_center(sectors, best), goal, nearest, parameters.alpha);
  direction = opening_of(sectors, best).nearest_to(direction, 0);
  return {direction,
          speed_fraction(sectors.free_distance(direction), target_distance,
                         parameters.slow_distance, parameters.target_slow_down * sectors.meter)};
}

}  // namespace follow_the_gap_holonomic
