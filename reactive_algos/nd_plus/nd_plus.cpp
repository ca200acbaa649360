#include "nd_plus/nd_plus.h"

#include <algorithm>

namespace nd_plus {

using namespace reactive;

const NdPlus::Settings& NdPlus::settings() {
  static constexpr Settings kSettings = {
      {{"safety_distance", "0.12", "length", "D_s of the safety zone"},
       &Parameters::safety_distance,
       1e-3},
      {{"gap", "0.2", "length", "a jump of the way by more is a gap"}, &Parameters::gap, 1e-3},
      {{"passable", "0.15", "length", "sectors whose way is shorter are closed"},
       &Parameters::passable},
      {{"wide_valley", "0.9", "rad", "s_max: a wider valley is wide"},
       &Parameters::wide_valley,
       0,
       2 * kPi},
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

Threats find_threats(const Sectors& sectors, double direction, double safety_distance) {
  Threats threats;
  threats.left_way = threats.right_way = safety_distance;
  double left_best = safety_distance, right_best = safety_distance;
  for (std::size_t k = 0; k < sectors.count(); ++k) {
    const double way = sectors.ways[k];
    const double aside = wrapped(sectors.direction(k) - direction);
    // Of equally near ones that which is nearest to the direction.
    const double nearer = way - 1e-9 * (kPi - std::abs(aside));
    if (way >= safety_distance) continue;
    if (aside > 0 && nearer < left_best) {
      left_best = nearer;
      threats.left = true;
      threats.left_way = way;
      threats.left_direction = sectors.direction(k);
    }
    if (aside <= 0 && nearer < right_best) {
      right_best = nearer;
      threats.right = true;
      threats.right_way = way;
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

/// LS1 and LSGR: turned away from the one threat, up to straight away from it, the more the deeper
/// it is in the safety zone.
double NdPlus::away_from(const Threats& threats, double direction) const {
  const bool left = threats.left && (!threats.right || threats.left_way < threats.right_way);
  const double way = left ? threats.left_way : threats.right_way;
  const double at = left ? threats.left_direction : threats.right_direction;
  const double depth = std::clamp(1 - way / parameters.safety_distance, 0.0, 1.0);
  const double angle = wrapped(at - direction);
  return wrapped(direction - depth * std::copysign(kPi - std::abs(angle), angle));
}

/// LS2: between both threats; as the nearer one is nearer, away from it and towards the other.
double NdPlus::centred(const Threats& threats, double direction) const {
  const double ds = parameters.safety_distance;
  const double left = 1 - threats.left_way / ds, right = 1 - threats.right_way / ds;
  const double away_left = kPi - std::abs(wrapped(threats.left_direction - direction));
  const double away_right = kPi - std::abs(wrapped(threats.right_direction - direction));
  // Both push with their depth; what they agree on is the middle.
  const double turn =
      (right * right * away_right - left * left * away_left) / std::max(1e-9, left + right);
  return wrapped(direction + turn);
}

Decision NdPlus::decide(const Sectors& sectors, const Point& target) {
  const double to_target = std::atan2(target.y, target.x);
  const double left = std::hypot(target.x, target.y);
  const auto valleys =
      find_valleys(sectors.ahead(parameters.field_of_view), parameters.gap, parameters.passable);
  // Up to here an obstacle's edge against free space is a gap for certain.
  const Choice choice =
      choose_valley(valleys, sectors, target, sectors.limit - 1.25 * parameters.gap);
  double wanted = to_target;
  bool wide = true;
  if (choice.valley == nullptr) return search_.next(to_target);
  search_.end();
  if (!choice.holds_target) {
    const Opening& span = choice.valley->span;
    wide = span.width >= parameters.wide_valley;
    const double inside = 0.5 * parameters.wide_valley;
    wanted =
        wide ? wrapped(choice.low_end ? span.low + inside : span.high() - inside) : span.middle();
  }
  const Threats threats = find_threats(sectors, wanted, parameters.safety_distance);
  const Situation now = situation(threats, choice.holds_target, wide ? parameters.wide_valley : 0,
                                  parameters.wide_valley);
  double direction = wanted;
  if (now == Situation::Ls2 || (now == Situation::Lsgr && threats.left && threats.right))
    direction = centred(threats, wanted);
  else if (now == Situation::Ls1 || now == Situation::Lsgr)
    direction = away_from(threats, wanted);
  // Low safety: slower, the deeper the nearest obstacle and the more the robot must turn.
  const double nearest = std::min(threats.left_way, threats.right_way);
  const double safety = nearest / parameters.safety_distance;
  const double turned = std::max(0.0, 1 - std::abs(direction) / (0.5 * kPi));
  const double free = speed_share(sectors.way(direction), left, parameters.slow_distance,
                                  parameters.target_slow_down);
  const bool low = now == Situation::Lsgr || now == Situation::Ls1 || now == Situation::Ls2;
  return {direction, low ? std::max(kCreep, std::min(free, std::max(0.3, safety) * turned)) : free};
}

}  // namespace nd_plus
