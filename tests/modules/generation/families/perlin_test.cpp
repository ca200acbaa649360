// SPDX-License-Identifier: BSD-3-Clause
#include "family_samples.h"

#include <slalom/generation/perlin.h>
#include <slalom/scenario/occupancy.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

TEST(Perlin, OccupiesTheRequiredFractionOfCells) {
  const auto perlin = family("perlin", "min_fill = 0.25\nmax_fill = 0.25\n");
  RandomEngine engine(2);
  for (int i = 0; i < 5; ++i) {
    const Occupancy cells = make_occupancy(perlin->generate("x", engine), 1);
    EXPECT_EQ(cells.cells().size(), 240U * 240U);
    EXPECT_EQ(cells.count_occupied(), 240U * 240U / 4);
  }
}

TEST(Perlin, CanBeEmpty) {
  RandomEngine engine(2);
  EXPECT_EQ(
      make_occupancy(family("perlin", "min_fill = 0\nmax_fill = 0\n")->generate("x", engine), 1)
          .count_occupied(),
      0U);
}

TEST(ValueNoise, OneLayerIsBoundedAndSmooth) {
  RandomEngine engine(2);
  const double spacing = 20;
  const auto noise = value_noise(engine, 200, 100, spacing, 1, 0.5);
  EXPECT_GE(*std::min_element(noise.begin(), noise.end()), 0);
  EXPECT_LT(*std::max_element(noise.begin(), noise.end()), 1);
  // The maximum slope of the step is 15/8; values differ by less than 1.
  for (std::size_t i = 0; i + 1 < noise.size(); ++i)
    if (i % 200 != 199) {
      EXPECT_LE(std::abs(noise[i + 1] - noise[i]), 15.0 / 8 / spacing);
    }
}

TEST(ValueNoise, LayersAreWeighted) {
  // With persistence 0 all layers but the first vanish, though their values are drawn.
  RandomEngine one(2), other(2);
  EXPECT_EQ(value_noise(one, 50, 50, 16, 1, 0.5), value_noise(other, 50, 50, 16, 4, 0));
}

TEST(Perlin, RejectsInvalidOptions) {
  EXPECT_NE(refusal("perlin", "feature = 0.01\n")
                .find("[generator.perlin] feature: is less than a "
                      "cell"),
            std::string::npos);
  EXPECT_NE(refusal("perlin", "cell = 1e-7\n").find("cell"), std::string::npos);
  EXPECT_NE(refusal("perlin", "min_fill = 0.9\n").find("max_fill"), std::string::npos);
}

}  // namespace
}  // namespace slalom
