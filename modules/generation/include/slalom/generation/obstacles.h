// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/core/random.h>
#include <slalom/generation/start_goal.h>
#include <slalom/scenario/geometry.h>

namespace slalom {

enum class SizeDistribution {
  Uniform,
  LogNormal,  ///< the mean of the logarithm is that of the limits' logarithms
  PowerLaw    ///< density proportional to size^-size_exponent
};
constexpr auto enum_names(SizeDistribution) {
  return std::array{"uniform", "log_normal", "power_law"};
}

/// The distribution of obstacle sizes, truncated to [min_size, max_size].
struct SizeOptions {
  double min_size = 0.15,
         max_size = 0.8;  ///< m, radius of a disc or of the circumscribed circle of a polygon
  SizeDistribution size_distribution = SizeDistribution::Uniform;
  double size_log_sigma = 0.5;  ///< standard deviation of the natural logarithm, for log_normal
  double size_exponent = 2.5;   ///< for power_law

  void visit(OptionVisitor& v);
};

double sample_obstacle_size(RandomEngine& engine, const SizeOptions& options);  ///< m

/// Random discs and polygons.
struct ObstacleOptions {
  int min_obstacles = 6, max_obstacles = 40;  ///< number, drawn per scenario
  SizeOptions size;
  double polygon_fraction = 0.5;  ///< fraction of obstacles that are polygons
  double concave_fraction = 0.3;  ///< fraction of polygons that are star-shaped, not convex

  void visit(OptionVisitor& v);
};

/// Discs and polygons of random size, with centers uniformly distributed over the points within
/// `bounds` that `is_valid` accepts. Obstacles closer than `clear_radius` (m) to start or goal are
/// omitted.
Primitives scatter_obstacles(RandomEngine& engine, const ObstacleOptions& options,
                             const Bounds& bounds, const StartGoal& start_goal, double clear_radius,
                             const PositionFilter& is_valid = {});

}  // namespace slalom
