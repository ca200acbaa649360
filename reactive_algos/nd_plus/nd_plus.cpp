// SPDX-License-Identifier: BSD-3-Clause
#include "nd_plus/nd_plus.h"

#include <slalom/core/math.h>

#include <algorithm>

namespace nd_plus {

using namespace reactive;

void Parameters::visit(slalom::OptionVisitor& v) {
  using slalom::Range;
  v.option("safety_distance", safety_distance, "length", "D_s of the safety zone",
           Range::at_least(1e-3));
  v.option("gap", gap, "length", "minimum discontinuity of the free distance at a gap",
           Range::at_least(1e-3));
  v.option("passable", passable, "length", "sectors with a smaller free distance are closed",
           Range::at_least(0));
  v.option("wide_valley", wide_valley, "rad", "s_max: valleys wider than this are wide",
           Range::between(0, 2 * M_PI));
  v.option("field_of_view", field_of_view, "rad", "valleys outside it are ignored",
           Range::between(0.1, 2 * M_PI));
  v.option("slow_distance", slow_distance, "length",
           "below this free distance the robot slows down", Range::at_least(0));
  v.option("target_slow_down", target_slow_down, "m",
           "below this distance to the target the robot slows down", Range::at_least(0));
}

Threats find_threats(const Sectors& sectors, double direction, double safety_distance) {
  Threats threats;
  threats.left_distance = threats.right_distance = safety_distance;
  double left_best = safety_distance, right_best = safety_distance;
  for (std::size_t k = 0; k < sectors.count(); ++k) {
    const double free_distance = sectors.free_distances[k];
    const double aside = wrapped(sectors.direction(k) - direction);
    // Among equal distances, take the one closest to the direction.
    const double nearer = free_distance - 1e-9 * (M_PI - std::abs(aside));
    if (free_distance >= safety_distance) continue;
    if (aside > 0 && nearer < left_best) {
      left_best = nearer;
      threats.left = true;
      threats.left_distance = free_distance;
      threats.left_direction = sectors.direction(k);
    }
    if (aside <= 0 && nearer < right_best) {
      right_best = nearer;
      threats.right = true;
      threats.right_distance = free_distance;
      threats.right_direction = sectors.direction(k);
    }
  }
  return threats;
}

Situation situation(const Threats& threats, bool goal_in_region, double width, double wide_valley) {
  if (threats.left || threats.right) {
    if (goal_in_region) return Situation::Lsgr;
    return threats.left && threats.right ? Situation::Ls2 : Situation::Ls1;
  }
  if (goal_in_region) return Situation::Hsgr;
  return width >= wide_valley ? Situation::Hswr : Situation::Hsnr;
}

/// LS1 and LSGR: turns away from the threat, up to the opposite direction, in proportion to its
/// depth in the safety zone.
double NdPlus::turn_away(const Threats& threats, double direction) const {
  const bool left =
      threats.left && (!threats.right || threats.left_distance < threats.right_distance);
  const double free_distance = left ? threats.left_distance : threats.right_distance;
  const double threat_direction = left ? threats.left_direction : threats.right_direction;
  const double depth = std::clamp(1 - free_distance / parameters.safety_distance, 0.0, 1.0);
  const double angle = wrapped(threat_direction - direction);
  return wrapped(direction - depth * std::copysign(M_PI - std::abs(angle), angle));
}

/// LS2: balances both threats; turns away from the closer one.
double NdPlus::balance_threats(const Threats& threats, double direction) const {
  const double safety_distance = parameters.safety_distance;
  const double left = 1 - threats.left_distance / safety_distance,
               right = 1 - threats.right_distance / safety_distance;
  const double away_left = M_PI - std::abs(wrapped(threats.left_direction - direction));
  const double away_right = M_PI - std::abs(wrapped(threats.right_direction - direction));
  // Each threat deflects in proportion to its squared depth; equal threats cancel.
  const double turn =
      (right * right * away_right - left * left * away_left) / std::max(1e-9, left + right);
  return wrapped(direction + turn);
}

Decision NdPlus::decide(const Sectors& sectors, const Point& target) {
  const double to_target = slalom::math::atan2(target.y, target.x);
  const double target_distance = slalom::math::hypot(target.x, target.y);
  const auto valleys =
      find_valleys(sectors.ahead(parameters.field_of_view), parameters.gap, parameters.passable);
  // Up to this distance an obstacle edge against free space is always a gap.
  const Choice choice =
      choose_valley(valleys, sectors, target, sectors.limit - 1.25 * parameters.gap);
  double desired = to_target;
  bool wide = true;
  if (choice.valley == nullptr) return search_.next(to_target);
  search_.reset();
  if (!choice.contains_target) {
    const Opening& span = choice.valley->span;
    wide = span.width >= parameters.wide_valley;
    const double offset = 0.5 * parameters.wide_valley;
    desired =
        wide ? wrapped(choice.low_end ? span.low + offset : span.high() - offset) : span.middle();
  }
  const Threats threats = find_threats(sectors, desired, parameters.safety_distance);
  const Situation now = situation(threats, choice.contains_target,
                                  wide ? parameters.wide_valley : 0, parameters.wide_valley);
  double direction = desired;
  if (now == Situation::Ls2 || (now == Situation::Lsgr && threats.left && threats.right))
    direction = balance_threats(threats, desired);
  else if (now == Situation::Ls1 || now == Situation::Lsgr)
    direction = turn_away(threats, desired);
  // Low safety: slow down with the depth of the closest threat and the required turn.
  const double nearest = std::min(threats.left_distance, threats.right_distance);
  const double safety = nearest / parameters.safety_distance;
  const double turned = std::max(0.0, 1 - std::abs(direction) / (0.5 * M_PI));
  const double free =
      speed_fraction(sectors.free_distance(direction), target_distance, parameters.slow_distance,
                     parameters.target_slow_down * sectors.meter);
  const bool low = now == Situation::Lsgr || now == Situation::Ls1 || now == Situation::Ls2;
  return {direction,
          low ? std::max(kMinSpeedFraction, std::min(free, std::max(0.3, safety) * turned)) : free};
}

}  // namespace nd_plus
