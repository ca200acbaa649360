// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/straight_path.h>

namespace slalom {

/// Section [generator.passage]: a wall with one gap, which the robot faces.
struct PassageOptions {
  static constexpr char kFamily[] = "passage";
  double length = 10, height = 8;                             ///< m, across the wall and along it
  double min_width = 0.8, max_width = 1.2;                    ///< m, clear width of the gap
  double wall = 0.15;                                         ///< m, thickness
  double min_start_distance = 1.5, max_start_distance = 2.5;  ///< m, of the start
  double min_offset = 0, max_offset = 0.5;  ///< m, of the start from the gap's axis
  StartAngleOptions angle;                  ///< to the gap's axis
  StartGoalOptions start_goal = {0.6, 3, 0.8};

  void visit(OptionVisitor& v);
};

/// The start is in front of the gap, with offset and angle to either side. The goal is on the axis
/// of the gap, as far behind the wall, or farther if min_distance requires it.
std::unique_ptr<Generator> make_generator(const PassageOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
