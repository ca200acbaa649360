// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

/// Three quarters of a circle around (5, 5) at 1 m/s.
struct Arc : SampledRun {
  Arc(double radius, double hz)
      : SampledRun(1.5 * M_PI * radius, hz, [=](double t) {
          Sample sample;
          sample.pose = {5 + radius * std::cos(t / radius), 5 + radius * std::sin(t / radius), 0};
          return sample;
        }) {}
};

TEST(Curvature, OfACircleIsOneOverItsRadiusForAnySampling) {
  for (const double radius : {0.5, 1.0, 2.0})
    for (const double hz : {10.0, 20.0, 50.0}) {
      const Arc run(radius, hz);
      EXPECT_NEAR(run.number("max_curvature"), 1 / radius, 0.02 / radius) << radius << " " << hz;
      EXPECT_NEAR(run.number("bending_energy"), 1 / (radius * radius), 0.02 / (radius * radius));
    }
}

TEST(Curvature, OfAStraightLineIsZero) {
  const MeasuredRun run({{2, 5}, {2.3, 5}, {8, 5}});
  EXPECT_NEAR(run.number("max_curvature"), 0, 1e-9);
  EXPECT_NEAR(run.number("bending_energy"), 0, 1e-9);
}

TEST(BendingEnergy, IsAMeanOverTheLength) {
  // 4 m straight, then a half circle of radius 1 m: pi m of curvature 1.
  Path points;
  for (int i = 0; i < 40; ++i) points.emplace_back(2 + 0.1 * i, 4);
  for (int i = 0; i <= 40; ++i)
    points.emplace_back(6 + std::sin(i * M_PI / 40), 5 - std::cos(i * M_PI / 40));
  EXPECT_NEAR(MeasuredRun(points).number("bending_energy"), M_PI / (4 + M_PI), 0.02);
}

TEST(MaxCurvature, OfAReversalIsFinite) {
  const double k = MeasuredRun({{2, 5}, {4, 5}, {2, 5}}).number("max_curvature");
  EXPECT_GT(k, 10);  // a circle of a tenth of a meter
  EXPECT_LE(k, 20 + 1e-6);
}

TEST(Curvature, OfAPathShorterThanTwoSpacingsIsNa) {
  for (const std::string id : {"max_curvature", "bending_energy"}) {
    EXPECT_EQ(MeasuredRun({{2, 5}, {2.15, 5}}).reason(id), "the path is too short for a curvature");
    EXPECT_EQ(MeasuredRun({{2, 5}, {2, 5}}).reason(id), "the path is too short for a curvature");
  }
}

}  // namespace
}  // namespace slalom::testing
