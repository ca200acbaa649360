// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/start_goal.h>

#include <vector>

namespace slalom {

/// Section [generator.perlin]: rounded, cave-like shapes from smooth noise.
struct PerlinOptions {
  static constexpr char kFamily[] = "perlin";
  double width = 12, height = 12;         ///< m
  double cell = 0.05;                     ///< m, of the grid
  double feature = 2.5;                   ///< m, size of the largest shapes
  int octaves = 3;                        ///< layers of noise, each at half the scale
  double persistence = 0.5;               ///< weight of a layer relative to the previous one
  double min_fill = 0.1, max_fill = 0.3;  ///< fraction of occupied cells, drawn per scenario
  StartGoalOptions start_goal = {0.4, 8, 0.5};

  void visit(OptionVisitor& v);
};

/// Layered value noise (Perlin-like), thresholded such that the required fraction of cells is
/// occupied.
std::unique_ptr<Generator> make_generator(const PerlinOptions& options,
                                          const GeneratorContext& context = {});

/// Values of layered noise at the centers of cells, row-major: random values on the points of a
/// square lattice, feature_cells apart in the first layer, with smooth interpolation.
std::vector<double> value_noise(RandomEngine& engine, int columns, int rows, double feature_cells,
                                int octaves, double persistence);

}  // namespace slalom
