#pragma once

#include <slalom/core/options.h>
#include <slalom/core/random.h>
#include <slalom/generation/ends.h>
#include <slalom/scenario/geometry.h>

#include <string>

namespace slalom {

/// How large obstacles are: sizes lie between min_size and max_size whatever the distribution.
struct SizeOptions {
  double min_size = 0.15,
         max_size = 0.8;  ///< m, radius of a disc, or of the circle a polygon stands in
  /// uniform; log_normal: the logarithm is normal about the mean of the limits' logarithms, cut off
  /// at the limits; power_law: density proportional to size^-size_exponent.
  std::string size_distribution = "uniform";
  double size_log_sigma = 0.5;  ///< standard deviation of the natural logarithm, for log_normal
  double size_exponent = 2.5;   ///< for power_law

  void visit(OptionVisitor& v);
};

double draw_size(RandomEngine& engine, const SizeOptions& options);  ///< m

/// Random discs and polygons.
struct ObstacleOptions {
  int min_obstacles = 6, max_obstacles = 40;  ///< how many, drawn anew for each scenario
  SizeOptions size;
  double polygon_share = 0.5;  ///< share of obstacles that are polygons
  double concave_share = 0.3;  ///< share of polygons that are star-shaped, not convex

  void visit(OptionVisitor& v);
};

/// Discs and polygons of random size, their centres evenly spread over the places within `bounds`
/// that `is_good` accepts. One that would come nearer than `clear_radius` (m) to start or goal is
/// left out.
Primitives scatter_obstacles(RandomEngine& engine, const ObstacleOptions& options,
                             const Bounds& bounds, const Ends& ends, double clear_radius,
                             const PlaceTest& is_good = {});

}  // namespace slalom
