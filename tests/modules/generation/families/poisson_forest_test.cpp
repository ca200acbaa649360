// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "family_samples.h"

#include <slalom/generation/poisson_forest.h>

#include <cmath>

namespace slalom {
namespace {

TEST(PoissonDiscs, KeepTheirSpacingAndFillTheWorkspace) {
  const Bounds bounds = {-3, 2, 9, 12};
  for (const double spacing : {0.4, 1.0, 3.0}) {
    RandomEngine engine(17);
    const auto points = poisson_discs(engine, bounds, spacing);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_TRUE(bounds.contains(points[i]));
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GE(std::hypot(points[i].x - points[j].x, points[i].y - points[j].y), spacing);
    }
    // For a maximal set, circles of radius `spacing` around the points cover the workspace.
    EXPECT_GE(double(points.size()), bounds.area() / (M_PI * spacing * spacing)) << spacing;
  }
}

TEST(PoissonForest, TrunksHaveTheGivenSpacingAndSizes) {
  const auto forest = family("poisson_forest", "spacing = 1.2\nmin_size = 0.2\nmax_size = 0.3\n");
  RandomEngine engine(4);
  const Scenario scenario = forest->generate("x", engine);
  const std::vector<Disc>& trunks = scenario.primitives().discs;
  EXPECT_GT(trunks.size(), 30U);
  for (std::size_t i = 0; i < trunks.size(); ++i) {
    EXPECT_GE(trunks[i].radius, 0.2);
    EXPECT_LE(trunks[i].radius, 0.3);
    EXPECT_GE(distance(scenario.goal(), trunks[i]), 0.6);
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE(std::hypot(trunks[i].center.x - trunks[j].center.x,
                           trunks[i].center.y - trunks[j].center.y),
                1.2);
  }
}

TEST(PoissonForest, RejectsInvalidOptions) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "g.ini:2: [generator.poisson_forest] spacing:",
                           {"max_size", "expected at least twice max_size"},
                           [] { family("poisson_forest", "spacing = 0.5\n"); }));
  EXPECT_NE(
      refusal("poisson_forest", "width = 1e6\nheight = 1e6\n").find("too small for the workspace"),
      std::string::npos);
  EXPECT_NE(refusal("poisson_forest", "width = 1e12\nheight = 1e-6\nmargin = 0\nmin_distance = 0\n")
                .find("too small for the workspace"),
            std::string::npos);
  EXPECT_NE(refusal("poisson_forest", "spacing = -1\n").find("spacing"), std::string::npos);
}

}  // namespace
}  // namespace slalom
