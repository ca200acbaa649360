// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/hash.h>
#include <slalom/people/people_settings.h>

#include <cmath>

namespace slalom {

void PeopleSettings::visit(OptionVisitor& v) {
  v.option("model", model,
           "speed: a direction by repulsion, a speed by the gap ahead; orca: reciprocal avoidance");
  v.option("notices", notices, "-", "share of the people that notice the robot",
           Range::between(0, 1));
  v.option("period", period, "s", "time between two decisions of a person; it walks straight",
           Range::between(0.01, 1));
  v.option("side", side, "side to which people turn when held up");
  v.option("turn", turn, "rad", "turn of a person that is held up; 0: none",
           Range::between(0, M_PI / 2));
  v.option("keep_apart", keep_apart, "people never overlap; with orca they may jam at doors");
  v.option("haste", haste, "-", "maximum speed of a person over its preferred one",
           Range::between(1, 10));
  v.option("sight", sight, "m", "distance up to which people notice others",
           Range::between(0.1, 100));
  v.option("goal_tolerance", goal_tolerance, "m",
           "distance from its goal at which a person has arrived", Range::between(0.01, 10));
  v.option("wall_horizon", wall_horizon, "s", "time for which people avoid walls",
           Range::between(0.01, 10));
  v.option("time_gap", time_gap, "s", "time to the one ahead that people keep (speed)",
           Range::between(0.1, 10));
  v.option("horizon", horizon, "s", "time for which people avoid each other (orca)",
           Range::between(0.1, 100));
  v.option("margin", margin, "m", "distance added to each radius (orca)", Range::between(0, 1));
  v.option("max_neighbors", max_neighbors, "-", "nearest others that a person avoids (orca)",
           Range::between(1, 1000));
  v.option("share", share, "-", "share of the avoidance of the robot that people take (orca)",
           Range::between(0, 1));
  v.option("until_arrival", until_arrival, "s",
           "longest time after a run for which people go on, for their delay; 0: not measured",
           Range::between(0, 3600));
}

bool notices_robot(const std::string& scenario_hash, const std::string& id, double share) {
  constexpr std::size_t kDigits = 13;  // 52 bits, exact as a double
  Hasher hasher;
  hasher.add("notices").add(scenario_hash).add(id);
  const auto number = std::stoull(hasher.hex().substr(0, kDigits), nullptr, 16);
  return std::ldexp(static_cast<double>(number), -4 * int{kDigits}) < share;
}

}  // namespace slalom
