#pragma once

#include <slalom/generation/ends.h>
#include <slalom/generation/generator.h>

#include <vector>

namespace slalom {

/// Section [generator.perlin]: rounded, cave-like shapes from smooth noise.
struct PerlinOptions {
  double width = 12, height = 12;         ///< m
  double cell = 0.05;                     ///< m, of the grid
  double feature = 2.5;                   ///< m, size of the largest shapes
  int octaves = 3;                        ///< layers of noise, each half as large as the one before
  double persistence = 0.5;               ///< weight of a layer relative to the one before
  double min_fill = 0.1, max_fill = 0.3;  ///< share of occupied cells, drawn anew for each scenario
  EndsOptions ends = {0.4, 8, 0.5};

  void visit(OptionVisitor& v);
};

/// Value noise in layers (Perlin-like), cut off where the wanted share of cells lies above.
std::unique_ptr<Generator> make_perlin(const IniFile& ini, const GeneratorContext& context = {});

/// Values of layered noise at the centres of cells, row by row: random values on the points of a
/// square lattice, feature_cells apart in the first layer, joined by smooth steps.
std::vector<double> value_noise(RandomEngine& engine, int columns, int rows, double feature_cells,
                                int octaves, double persistence);

}  // namespace slalom
