// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "family_samples.h"

#include <slalom/generation/obstacles.h>

#include <cmath>

namespace slalom {
namespace {

SizeOptions sizes(SizeDistribution distribution) {
  SizeOptions options;
  options.min_size = 0.1;
  options.max_size = 1.6;
  options.size_distribution = distribution;
  return options;
}

/// The fraction of 10000 sizes below `limit`; its standard deviation is at most 0.5 / 100.
double fraction_below(double limit, const SizeOptions& options) {
  RandomEngine engine(1);
  int below = 0;
  for (int i = 0; i < 10000; ++i) {
    const double size = sample_obstacle_size(engine, options);
    EXPECT_GE(size, options.min_size);
    EXPECT_LE(size, options.max_size);
    below += size < limit ? 1 : 0;
  }
  return below / 10000.0;
}

constexpr double kFiveSigma = 0.025;

TEST(SampleObstacleSize, UniformSizesAreUniformlyDistributed) {
  EXPECT_NEAR(fraction_below(0.475, sizes(SizeDistribution::Uniform)), 0.25, kFiveSigma);
}

TEST(SampleObstacleSize, LogNormalSizesHaveTheGeometricMeanAsMedian) {
  SizeOptions options = sizes(SizeDistribution::LogNormal);
  EXPECT_NEAR(fraction_below(0.4, options), 0.5, kFiveSigma);  // sqrt(0.1 * 1.6) = 0.4
  // One standard deviation below: 15.87 % of a normal distribution, of which 0.56 % (2 * 0.28 %,
  // beyond ln 4 / 0.5 = 2.77 standard deviations) are truncated: (15.87 - 0.28) / 99.44 = 15.68 %.
  EXPECT_NEAR(fraction_below(0.4 * std::exp(-0.5), options), 0.1568, kFiveSigma);
}

TEST(SampleObstacleSize, PowerLawSizesFollowTheirDistributionFunction) {
  SizeOptions options = sizes(SizeDistribution::PowerLaw);
  options.size_exponent = 2.5;
  // F(s) = (1 - (s / min)^-1.5) / (1 - (max / min)^-1.5); F(0.2) = 0.64645 / 0.984375.
  EXPECT_NEAR(fraction_below(0.2, options), 0.6567, kFiveSigma);
  options.size_exponent = 1;  // F(s) = ln(s / min) / ln(max / min): F(0.4) = 1/2
  EXPECT_NEAR(fraction_below(0.4, options), 0.5, kFiveSigma);
}

TEST(ScatterObstacles, CentersLieAtValidPositions) {
  RandomEngine engine(2);
  ObstacleOptions options;
  options.polygon_fraction = 0;
  const StartGoal start_goal = {{-50, 0}, {50, 0}};
  const auto left = [](const mrpt::math::TPoint2D& p) { return p.x < 2; };
  const Primitives drawn =
      scatter_obstacles(engine, options, {0, 0, 10, 10}, start_goal, 0.5, left);
  EXPECT_GE(drawn.discs.size(), 6U);
  for (const Disc& disc : drawn.discs) EXPECT_LT(disc.center.x, 2);
}

TEST(RandomFamily, RejectsInvalidSizes) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "g.ini:3: [generator.random] max_size:",
                           {"less than min_size", "expected at least 2"},
                           [] { family("random", "min_size = 2\nmax_size = 1\n"); }));
  EXPECT_NE(refusal("random", "size_distribution = normal\n").find("size_distribution"),
            std::string::npos);
  EXPECT_NE(refusal("random", "min_obstacles = 7\nmax_obstacles = 6\n")
                .find("max_obstacles: is "
                      "less"),
            std::string::npos);
}

}  // namespace
}  // namespace slalom
