#pragma once

#include <slalom/core/options.h>
#include <slalom/generation/generator.h>

namespace slalom {

/// Section [generator.random]: discs and polygons on a rectangular floor.
struct RandomGeneratorOptions {
  double width = 12, height = 12;             ///< m
  int min_obstacles = 6, max_obstacles = 40;  ///< how many, drawn anew for each scenario
  double min_size = 0.15,
         max_size = 0.8;       ///< m, radius of a disc, or of the circle a polygon stands in
  double polygon_share = 0.5;  ///< share of obstacles that are polygons
  double concave_share = 0.3;  ///< share of polygons that are star-shaped, not convex
  double clear_radius = 0.6;   ///< m, kept free about start and goal
  double min_distance = 8;     ///< m, straight distance from start to goal
  double margin = 0.7;         ///< m, of start and goal from the border

  void visit(OptionVisitor& v);
};

/// Uniform random discs and polygons; start and goal anywhere at least min_distance apart, the
/// robot facing the goal within 45 degrees.
std::unique_ptr<Generator> make_random_generator(const IniFile& ini);

}  // namespace slalom
