// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/moving.h>

namespace slalom {

/// Section [generator.crossing]: movers that cross the path of the robot in an empty room.
struct CrossingOptions {
  static constexpr char kFamily[] = "crossing";
  double width = 14, height = 10;  ///< m
  double max_turn_deg = 30;        ///< between a mover's path and the normal of the robot's
  MoverOptions movers;
  bool people = false;  ///< people, who react, instead of movers
  StartGoalOptions start_goal = {0.8, 8, 1};

  void visit(OptionVisitor& v);
};

/// Each mover walks back and forth on a line through a point between start and goal, from border to
/// border; it begins anywhere on it.
std::unique_ptr<Generator> make_generator(const CrossingOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
