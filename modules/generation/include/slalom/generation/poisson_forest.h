#pragma once

#include <slalom/generation/ends.h>
#include <slalom/generation/generator.h>
#include <slalom/generation/obstacles.h>

#include <vector>

namespace slalom {

/// Section [generator.poisson_forest]: a wood of trunks no two of which stand close together.
struct PoissonForestOptions {
  double width = 12, height = 12;  ///< m
  double spacing = 1.6;            ///< m, least distance between centres of trunks
  SizeOptions trunks = {0.1, 0.35, "log_normal"};
  EndsOptions ends;

  void visit(OptionVisitor& v);
};

/// Discs whose centres come from Poisson-disc sampling; one nearer than clear_radius to start or
/// goal is left out.
std::unique_ptr<Generator> make_poisson_forest(const IniFile& ini,
                                               const GeneratorContext& context = {});

/// Points of the rectangle, any two at least `spacing` (m) apart, so dense that hardly another one
/// would fit: Bridson, "Fast Poisson disk sampling in arbitrary dimensions" (SIGGRAPH 2007), 30
/// candidates round each point.
std::vector<mrpt::math::TPoint2D> poisson_discs(RandomEngine& engine, const Bounds& bounds,
                                                double spacing);

}  // namespace slalom
