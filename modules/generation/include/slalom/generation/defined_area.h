// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/straight_path.h>

namespace slalom {

/// Section [generator.defined_area]: parallel aisles between walls, connected at alternate ends.
struct DefinedAreaOptions {
  static constexpr char kFamily[] = "defined_area";
  double length = 8;                             ///< m, of each aisle, inside, with its turns
  double min_width = 0.9, max_width = 1.4;       ///< m, clear width of aisles and turns
  int min_aisles = 2, max_aisles = 4;            ///< number, drawn per scenario
  double wall = 0.15;                            ///< m, thickness of the walls between aisles
  int min_impairments = 0, max_impairments = 2;  ///< number of boxes at the walls of aisles
  double min_free = 0.6, max_free = 0.9;         ///< fraction of the width beside a box
  double impairment = 0.4;                       ///< m, length of a box along the aisle
  StartAngleOptions angle;
  StartGoalOptions start_goal = {0.4, 1, 0.4};

  void visit(OptionVisitor& v);
};

/// The start is at the closed end of the first aisle, the goal at that of the last one, or nearer
/// to its beginning if min_distance requires it.
std::unique_ptr<Generator> make_generator(const DefinedAreaOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
