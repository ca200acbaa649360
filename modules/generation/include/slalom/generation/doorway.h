// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/moving.h>

namespace slalom {

/// Section [generator.doorway]: two rooms and a door, through which movers come toward the robot.
struct DoorwayOptions {
  static constexpr char kFamily[] = "doorway";
  double width = 12, height = 8;        ///< m, of both rooms together
  double min_door = 1.2, max_door = 2;  ///< m, clear width of the door, drawn per scenario
  double wall = 0.15;                   ///< m, thickness
  double max_wait = 15;                 ///< s, until a mover begins to walk
  MoverOptions movers = {2, 5, 0.2, 0.35, 0.4, 1.2};
  bool people = false;  ///< people, who react and do not wait, instead of movers
  StartGoalOptions start_goal = {0.8, 6, 0.8};

  void visit(OptionVisitor& v);
};

/// The robot goes from the left room to the right one. Each mover waits in the right room, goes
/// through the middle of the door and stops in the left one, away from the start.
std::unique_ptr<Generator> make_generator(const DoorwayOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
