// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

namespace slalom {

/// How the robot changes the velocities that a person chooses in a run, relative to those that it
/// would choose at the same place and among the same others without the robot.
struct Hindrance {
  bool is_noticed = false;  ///< the person notices the robot
  int updates = 0;          ///< those in which the robot is in reach of the person
  /// s, the sum over the updates of the way towards the next point of the route that is lost in a
  /// period, at the preferred speed; negative if the person gains by the robot
  double time = 0;
  double speed_change = 0;  ///< m/s, the sum over the updates of the change of the velocity
  /// s, at the preferred speed, of the route that the person has covered less of than it would have
  /// without a robot by then; negative if it has covered more
  double deficit = 0;
  /// s, by which the person arrives later than without a robot: none if it does not arrive in both,
  /// or PeopleSettings::until_arrival is 0
  std::optional<double> delay = std::nullopt;
  /// s, by which it would arrive at another time without a robot if the first person started 1e-12
  /// m beside its start: delays that are not larger mean nothing
  std::optional<double> delay_floor = std::nullopt;

  bool operator==(const Hindrance& other) const {
    return is_noticed == other.is_noticed && updates == other.updates && time == other.time &&
           speed_change == other.speed_change && deficit == other.deficit && delay == other.delay &&
           delay_floor == other.delay_floor;
  }
};

/// Per person, in the order of the scenario.
using Hindrances = std::vector<Hindrance>;

}  // namespace slalom
