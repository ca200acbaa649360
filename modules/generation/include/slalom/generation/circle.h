// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/moving.h>

namespace slalom {

/// Section [generator.circle]: the robot and movers on a circle, each bound for the opposite point.
struct CircleOptions {
  static constexpr char kFamily[] = "circle";
  double min_circle = 4, max_circle = 5;  ///< m, radius of the circle, drawn per scenario
  double max_shift_deg = 10;              ///< of a mover along the circle
  MoverOptions movers;
  StartGoalOptions start_goal = {0.5, 8, 0.8};

  void visit(OptionVisitor& v);
};

/// The movers and the robot are spread evenly on the circle, movers moved by up to max_shift_deg.
/// All movers set off when the run begins, go straight through the center and stop at the end.
std::unique_ptr<Generator> make_generator(const CircleOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
