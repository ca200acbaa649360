#pragma once

#include <slalom/generation/ends.h>
#include <slalom/generation/generator.h>

#include <vector>

namespace slalom {

/// Section [generator.traps]: walls that are open towards the start, on the way to the goal.
struct TrapsOptions {
  double width = 14, height = 10;             ///< m
  int min_traps = 2, max_traps = 5;           ///< how many, drawn anew for each scenario
  double min_depth = 1, max_depth = 2.5;      ///< m, inside, of a U; a dead end is twice as deep
  double min_opening = 1.4, max_opening = 3;  ///< m, inside width of a U
  double dead_end_share = 0.4;                ///< share of traps that are dead ends
  double dead_end_width = 1;                  ///< m, inside
  double wall = 0.15;                         ///< m, thickness
  double max_turn_deg = 30;  ///< by how much a trap's mouth may look past the start
  double gap = 0.8;          ///< m, at least, between traps
  EndsOptions ends = {0.7, 8, 0.8};

  void visit(OptionVisitor& v);
};

/// U-traps and dead ends about the straight line from start to goal; the first lies across it.
std::unique_ptr<Generator> make_traps(const IniFile& ini, const GeneratorContext& context = {});

/// A trap: three walls about a pocket that is open at one side.
struct Trap {
  mrpt::math::TPoint2D center;    ///< m, of the rectangle about its walls
  double direction = 0;           ///< rad, in which one leaves it
  double depth = 0, opening = 0;  ///< m, inside
};

Polygon outline(const Trap& trap, double wall);         ///< of its walls
double bounding_radius(const Trap& trap, double wall);  ///< m, of the circle about it

/// Traps between `ends` within the floor, the first across the straight line; fewer than drawn
/// where they would come too near to each other or to start or goal.
std::vector<Trap> draw_traps(RandomEngine& engine, const TrapsOptions& options, const Ends& ends);

}  // namespace slalom
