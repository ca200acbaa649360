// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/moving.h>

namespace slalom {

/// Common options of [generator.oncoming] and [generator.overtaking]: a corridor along which the
/// robot and moving obstacles go. Its walls are the border of the workspace.
struct CorridorFlowOptions {
  double length = 16;                   ///< m
  double min_width = 2, max_width = 4;  ///< m, drawn per scenario
  MoverOptions movers;
  bool people = false;  ///< people, who react, instead of movers
  StartGoalOptions start_goal = {1, 10, 0.6};

  void visit(OptionVisitor& v);
};

/// Section [generator.oncoming].
struct OncomingOptions : CorridorFlowOptions {
  static constexpr char kFamily[] = "oncoming";
};

/// Section [generator.overtaking].
struct OvertakingOptions : CorridorFlowOptions {
  static constexpr char kFamily[] = "overtaking";
  OvertakingOptions() { movers.min_speed = 0.1, movers.max_speed = 0.4; }
};

/// Movers come toward the robot and vanish at the end of the corridor behind it.
std::unique_ptr<Generator> make_generator(const OncomingOptions& options,
                                          const GeneratorContext& context = {});
/// Movers go ahead of the robot, slower than it, and vanish at the end of the corridor.
std::unique_ptr<Generator> make_generator(const OvertakingOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
