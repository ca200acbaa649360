#include "smooth_nd/smooth_nd.h"

#include <algorithm>

namespace smooth_nd {

using namespace reactive;

const SmoothNd::Settings& SmoothNd::settings() {
  static constexpr Settings kSettings = {
      {{"safety_distance", "0.15", "length", "D_s: obstacles nearer than that are threats"},
       &Parameters::safety_distance,
       1e-3},
      {{"gap", "0.2", "length", "a jump of the way by more is a gap"}, &Parameters::gap, 1e-3},
      {{"passable", "0.15", "length", "sectors whose way is shorter are closed"},
       &Parameters::passable},
      {{"wide_valley", "0.9", "rad", "s_max: how far from its gap a wide valley is entered"},
       &Parameters::wide_valley,
       0,
       2 * kPi},
      {{"slow_angle", "1.57", "rad", "the robot stands at this deviation from straight ahead"},
       &Parameters::slow_angle,
       0.1,
       kPi},
      {{"field_of_view", "3.1416", "rad", "valleys are looked for ahead only"},
       &Parameters::field_of_view,
       0.1,
       2 * kPi},
      {{"slow_distance", "0.3", "length", "slower when less way than this is ahead"},
       &Parameters::slow_distance},
      {{"target_slow_down", "0.15", "length", "slower when the target is nearer"},
       &Parameters::target_slow_down}};
  return kSettings;
}

double threat(double way, double safety_distance) {
  return std::clamp((safety_distance - way) / safety_distance, 0.0, 1.0);
}

double deflection(const Sectors& sectors, double direction, double safety_distance) {
  double sum = 0, weight = 0;
  for (std::size_t k = 0; k < sectors.count(); ++k) {
    const double s = threat(sectors.ways[k], safety_distance);
    if (s <= 0) continue;
    const double to_obstacle = wrapped(sectors.direction(k) - direction);
    // As far as straight away from the obstacle: pi less the angle to it, to the other side.
    const double away = -std::copysign(kPi - std::abs(to_obstacle), to_obstacle);
    sum += s * s * s * away;
    weight += s * s;
  }
  return weight > 0 ? sum / weight : 0;
}

Decision SmoothNd::decide(const Sectors& sectors, const Point& target) {
  const double to_target = std::atan2(target.y, target.x);
  const double left = std::hypot(target.x, target.y);
  const auto valleys =
      find_valleys(sectors.ahead(parameters.field_of_view), parameters.gap, parameters.passable);
  // Up to here an obstacle's edge against free space is a gap for certain.
  const Choice choice =
      choose_valley(valleys, sectors, target, sectors.limit - 1.25 * parameters.gap);
  if (choice.valley == nullptr) return search_.next(to_target);
  search_.end();
  const double inside = 0.5 * parameters.wide_valley;
  const double wanted =
      choice.holds_target ? to_target : choice.valley->span.nearest_to(to_target, inside);
  const double direction =
      wrapped(wanted + deflection(sectors, wanted, parameters.safety_distance));
  const double ahead = std::max(0.0, 1 - std::abs(direction) / parameters.slow_angle);
  const double free = speed_share(sectors.way(direction), left, parameters.slow_distance,
                                  parameters.target_slow_down);
  return {direction, std::max(kCreep, std::min(free, ahead + kCreep))};
}

}  // namespace smooth_nd
