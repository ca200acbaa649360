// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/enum_names.h>
#include <slalom/core/options.h>

#include <string>

namespace slalom {

/// The way in which people choose their velocities (speed_model.h, orca.h).
enum class PeopleModel { Speed, Orca };
constexpr auto enum_names(PeopleModel) {
  return std::array{"speed", "orca"};
}

/// The side to which people turn.
enum class PeopleSide { Right, Left };
constexpr auto enum_names(PeopleSide) {
  return std::array{"right", "left"};
}

/// The behavior of the people of a scenario.
struct PeopleSettings {
  PeopleModel model = PeopleModel::Speed;
  double notices = 1;
  double period = 0.1;  ///< s
  PeopleSide side = PeopleSide::Right;
  double turn = 1;  ///< rad
  bool keep_apart = true;
  double haste = 1.3;
  double sight = 5;             ///< m
  double goal_tolerance = 0.3;  ///< m
  double wall_horizon = 0.3;    ///< s
  double time_gap = 1;          ///< s
  double horizon = 2;           ///< s
  double margin = 0;            ///< m
  int max_neighbors = 10;
  double share = 0.5;
  double until_arrival = 0;  ///< s

  void visit(OptionVisitor& v);
};

/// Whether a person notices the robot if a share of people does: those that do at one share do at
/// each greater one, in every run among the scenario.
bool notices_robot(const std::string& scenario_hash, const std::string& id, double share);

}  // namespace slalom
