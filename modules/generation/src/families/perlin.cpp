// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"
#include "grid_scenario.h"

#include <slalom/generation/perlin.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kMaxCells = 25e6;

/// One layer of noise: random values in [0, 1) on a lattice, interpolated.
class NoiseLayer {
 public:
  NoiseLayer(RandomEngine& engine, int columns, int rows, double spacing)
      : spacing_(spacing), points_x_(points_along(columns)), values_() {
    const std::size_t count = points_x_ * points_along(rows);
    for (std::size_t i = 0; i < count; ++i) values_.push_back(uniform_real(engine, 0, 1));
  }

  double at(double x, double y) const {
    const double u = x / spacing_, v = y / spacing_;
    const auto i = static_cast<std::size_t>(u), j = static_cast<std::size_t>(v);
    const double a = step(u - std::floor(u)), b = step(v - std::floor(v));
    const double* low = &values_[j * points_x_ + i];
    const double* high = low + points_x_;
    return (1 - b) * ((1 - a) * low[0] + a * low[1]) + b * ((1 - a) * high[0] + a * high[1]);
  }

 private:
  std::size_t points_along(int cells) const {
    return static_cast<std::size_t>(cells / spacing_) + 2;
  }
  /// Smooth step from 0 to 1 with zero first and second derivatives at both ends.
  static double step(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

  double spacing_;
  std::size_t points_x_;
  std::vector<double> values_;
};

class Perlin : public Generator {
 public:
  explicit Perlin(const PerlinOptions& options) : options_(options) {}

  std::string name() const override { return "perlin"; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const double fill = uniform_real(engine, options_.min_fill, options_.max_fill);
    const Occupancy cells = filled(engine, fill);
    const DistanceField field(cells);
    const StartGoal start_goal =
        sample_start_goal(engine, cells.bounds(), options_.start_goal,
                          clearance_filter(field, options_.start_goal.clear_radius));
    return grid_scenario(scenario_name, cells, start_pose(engine, start_goal), start_goal.goal);
  }

 private:
  /// Occupies the fraction `fill` of the cells with the highest noise values.
  Occupancy filled(RandomEngine& engine, double fill) const {
    const auto along = [&](double length) {
      return std::max(1, static_cast<int>(std::lround(length / options_.cell)));
    };
    Occupancy cells(along(options_.width), along(options_.height), options_.cell, {0, 0});
    const std::vector<double> noise =
        value_noise(engine, cells.size_x(), cells.size_y(), options_.feature / options_.cell,
                    options_.octaves, options_.persistence);
    const auto count = static_cast<std::ptrdiff_t>(std::lround(fill * double(noise.size())));
    if (count == 0) return cells;
    std::vector<double> sorted = noise;
    std::nth_element(sorted.begin(), sorted.end() - count, sorted.end());
    const double threshold = *(sorted.end() - count);
    for (int y = 0; y < cells.size_y(); ++y)
      for (int x = 0; x < cells.size_x(); ++x)
        if (noise[cells.index(x, y)] >= threshold) cells.set_occupied(x, y, true);
    return cells;
  }

  PerlinOptions options_;
};

}  // namespace

std::vector<double> value_noise(RandomEngine& engine, int columns, int rows, double feature_cells,
                                int octaves, double persistence) {
  std::vector<double> noise(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
  double spacing = feature_cells, weight = 1;
  for (int octave = 0; octave < octaves && spacing >= 1; ++octave) {
    const NoiseLayer layer(engine, columns, rows, spacing);
    std::size_t i = 0;
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) noise[i++] += weight * layer.at(x + 0.5, y + 0.5);
    spacing /= 2;
    weight *= persistence;
  }
  return noise;
}

void PerlinOptions::visit(OptionVisitor& v) {
  v.option("width", width, "m", "width of the workspace", Range::positive());
  v.option("height", height, "m", "height of the workspace", Range::positive());
  v.option("cell", cell, "m", "side of a cell of the grid", Range::positive());
  v.option("feature", feature, "m", "size of the largest shapes", Range::positive());
  v.option("octaves", octaves, "-", "layers of noise, each at half the scale",
           Range::between(1, 16));
  v.option("persistence", persistence, "-", "weight of a layer relative to the previous one",
           Range::between(0, 1));
  v.option("min_fill", min_fill, "-", "minimum fraction of occupied cells", Range::between(0, 1));
  v.option("max_fill", max_fill, "-", "maximum fraction of occupied cells", Range::between(0, 1));
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const PerlinOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(PerlinOptions::kFamily, context);
  const auto options = checks.scaled(given);
  checks.expect_order("min_fill", options.min_fill, "max_fill", options.max_fill);
  checks.expect(options.feature >= options.cell, "feature", "is less than a cell", "at least cell");
  checks.expect(
      (options.width / options.cell + 1) * (options.height / options.cell + 1) <= kMaxCells, "cell",
      "is too small for the workspace", "at most 25 million cells");
  checks.expect_start_goal_fit(options.start_goal, options.width, options.height);
  return std::make_unique<Perlin>(options);
}

}  // namespace slalom
