// SPDX-License-Identifier: BSD-3-Clause
#include "smooth_nd/smooth_nd.h"

#include <slalom/core/math.h>

#include <algorithm>

namespace smooth_nd {

using namespace reactive;

void Parameters::visit(slalom::OptionVisitor& v) {
  using slalom::Range;
  v.option("safety_distance", safety_distance, "length",
           "D_s: obstacles closer than this are threats", Range::at_least(1e-3));
  v.option("gap", gap, "length", "minimum discontinuity of the free distance at a gap",
           Range::at_least(1e-3));
  v.option("passable", passable, "length", "sectors with a smaller free distance are closed",
           Range::at_least(0));
  v.option("wide_valley", wide_valley, "rad",
           "s_max: a wide valley is entered at half this angle from its gap",
           Range::between(0, 2 * M_PI));
  v.option("slow_angle", slow_angle, "rad", "heading deviation at which the speed is minimal",
           Range::between(0.1, M_PI));
  v.option("field_of_view", field_of_view, "rad", "valleys outside it are ignored",
           Range::between(0.1, 2 * M_PI));
  v.option("slow_distance", slow_distance, "length",
           "below this free distance the robot slows down", Range::at_least(0));
  v.option("target_slow_down", target_slow_down, "m",
           "below this distance to the target the robot slows down", Range::at_least(0));
}

double threat(double free_distance, double safety_distance) {
  return std::clamp((safety_distance - free_distance) / safety_distance, 0.0, 1.0);
}

double deflection(const Sectors& sectors, double direction, double safety_distance) {
  double sum = 0, weight = 0;
  for (std::size_t k = 0; k < sectors.count(); ++k) {
    const double s = threat(sectors.free_distances[k], safety_distance);
    if (s <= 0) continue;
    const double to_obstacle = wrapped(sectors.direction(k) - direction);
    // To the opposite direction: pi minus the angle to the obstacle, to the other side.
    const double away = -std::copysign(M_PI - std::abs(to_obstacle), to_obstacle);
    sum += s * s * s * away;
    weight += s * s;
  }
  return weight > 0 ? sum / weight : 0;
}

Decision SmoothNd::decide(const Sectors& sectors, const Point& target) {
  const double to_target = slalom::math::atan2(target.y, target.x);
  const double target_distance = slalom::math::hypot(target.x, target.y);
  const auto valleys =
      find_valleys(sectors.ahead(parameters.field_of_view), parameters.gap, parameters.passable);
  // Up to this distance an obstacle edge against free space is always a gap.
  const Choice choice =
      choose_valley(valleys, sectors, target, sectors.limit - 1.25 * parameters.gap);
  if (choice.valley == nullptr) return search_.next(to_target);
  search_.reset();
  const double offset = 0.5 * parameters.wide_valley;
  const double desired =
      choice.contains_target ? to_target : choice.valley->span.nearest_to(to_target, offset);
  const double direction =
      wrapped(desired + deflection(sectors, desired, parameters.safety_distance));
  const double ahead = std::max(0.0, 1 - std::abs(direction) / parameters.slow_angle);
  const double free =
      speed_fraction(sectors.free_distance(direction), target_distance, parameters.slow_distance,
                     parameters.target_slow_down * sectors.meter);
  return {direction, std::max(kMinSpeedFraction, std::min(free, ahead + kMinSpeedFraction))};
}

}  // namespace smooth_nd
