// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/obstacles.h>
#include <slalom/generation/start_goal.h>

#include <vector>

namespace slalom {

/// Section [generator.poisson_forest]: trunks with a minimum spacing.
struct PoissonForestOptions {
  static constexpr char kFamily[] = "poisson_forest";
  double width = 12, height = 12;  ///< m
  double spacing = 1.6;            ///< m, minimum distance between centers of trunks
  SizeOptions trunks = {0.1, 0.35, SizeDistribution::LogNormal};
  StartGoalOptions start_goal;

  void visit(OptionVisitor& v);
};

/// Discs whose centers come from Poisson-disc sampling; those closer than clear_radius to start or
/// goal are omitted.
std::unique_ptr<Generator> make_generator(const PoissonForestOptions& options,
                                          const GeneratorContext& context = {});

/// Points of the rectangle, pairwise at least `spacing` (m) apart and nearly maximal: Bridson,
/// "Fast Poisson disk sampling in arbitrary dimensions" (SIGGRAPH 2007), 30 candidates around each
/// point.
std::vector<mrpt::math::TPoint2D> poisson_discs(RandomEngine& engine, const Bounds& bounds,
                                                double spacing);

}  // namespace slalom
