// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/start_goal.h>

#include <vector>

namespace slalom {

/// Section [generator.traps]: U-shaped walls between start and goal, open toward the start.
struct TrapsOptions {
  static constexpr char kFamily[] = "traps";
  double width = 14, height = 10;             ///< m
  int min_traps = 2, max_traps = 5;           ///< number, drawn per scenario
  double min_depth = 1, max_depth = 2.5;      ///< m, inside, of a U; a dead end has twice that
  double min_opening = 1.4, max_opening = 3;  ///< m, inside width of a U
  double dead_end_fraction = 0.4;             ///< fraction of traps that are dead ends
  double dead_end_width = 1;                  ///< m, inside
  double wall = 0.15;                         ///< m, thickness
  double max_turn_deg = 30;  ///< maximum angle between a trap's opening and the start
  double gap = 0.8;          ///< m, minimum distance between traps
  StartGoalOptions start_goal = {0.7, 8, 0.8};

  void visit(OptionVisitor& v);
};

/// U-shaped traps and dead ends; the center of the first lies on the line from start to goal.
std::unique_ptr<Generator> make_generator(const TrapsOptions& options,
                                          const GeneratorContext& context = {});

/// A trap: three walls around a pocket that is open at one side.
struct Trap {
  mrpt::math::TPoint2D center;    ///< m, of the bounding rectangle of its walls
  double direction = 0;           ///< rad, from the inside to the opening
  double depth = 0, opening = 0;  ///< m, inside
};

Polygon outline(const Trap& trap, double wall);         ///< outline of its walls
double bounding_radius(const Trap& trap, double wall);  ///< m, of its circumscribed circle

/// Traps within the workspace, the first on the straight line; fewer than the number drawn where
/// they would come too close to each other or to start or goal.
std::vector<Trap> sample_traps(RandomEngine& engine, const TrapsOptions& options,
                               const StartGoal& start_goal);

}  // namespace slalom
