// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

  bool operator==(const Hindrance& other) const {
    return is_noticed == other.is_noticed && updates == other.updates && time == other.time &&
           speed_change == other.speed_change && deficit == other.deficit;
  }
};

/// Per person, in the order of the scenario.
using Hindrances = std::vector<Hindrance>;

}  // namespace slalom
