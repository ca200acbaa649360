// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

/// v(t) = exp(-5 t^2), t in [-1, 1) at 100 Hz: the example of Balasubramanian et al.
Sample bell(double t) {
  Sample sample;
  sample.v = std::exp(-5 * (t - 1) * (t - 1));
  return sample;
}

TEST(Sparc, EqualsThePublishedValue) {
  EXPECT_NEAR(SampledRun(1.99, 100, bell).number("sparc"), -1.41403, 5e-6);
}

TEST(LogDimensionlessJerk, EqualsThePublishedValue) {
  const double value = SampledRun(1.99, 100, bell).number("log_dimensionless_jerk");
  EXPECT_NEAR(value, -5.81636, 5e-6);
  EXPECT_NEAR(-std::exp(-value), -335.74684, 5e-4);
}

TEST(Smoothness, IsInvariantToScaleAndDirection) {
  const auto scaled = [](double t) {
    Sample sample = bell(t);
    sample.v *= -3;
    return sample;
  };
  for (const std::string id : {"sparc", "log_dimensionless_jerk"})
    EXPECT_NEAR(SampledRun(1.99, 100, scaled).number(id), SampledRun(1.99, 100, bell).number(id),
                1e-9);
}

TEST(Smoothness, IsLowerForAJerkyMotion) {
  const auto jerky = [](double t) {
    Sample sample = bell(t);
    sample.v *= 1 + 0.5 * std::sin(30 * t);
    return sample;
  };
  for (const std::string id : {"sparc", "log_dimensionless_jerk"})
    EXPECT_LT(SampledRun(1.99, 100, jerky).number(id), SampledRun(1.99, 100, bell).number(id));
}

TEST(Sparc, DoesNotDependOnASufficientSamplingRate) {
  // A bell of one second's width has no components beyond 2 Hz.
  const auto slow = [](double t) {
    Sample sample;
    sample.v = std::exp(-2 * (t - 4) * (t - 4));
    return sample;
  };
  const double expected = SampledRun(8, 100, slow).number("sparc");
  for (const double hz : {10.0, 20.0, 50.0})
    EXPECT_NEAR(SampledRun(8, hz, slow).number("sparc"), expected, 0.01 * std::abs(expected)) << hz;
}

TEST(Smoothness, IsNaWithoutMotionOrDuration) {
  for (const std::string id : {"sparc", "log_dimensionless_jerk"}) {
    EXPECT_EQ(MeasuredRun({{2, 5}, {2, 5}, {2, 5}}).reason(id), "the robot did not move");
    EXPECT_EQ(MeasuredRun({{2, 5}}).reason(id), "zero duration");
    EXPECT_EQ(MeasuredRun({{2, 5}, {3, 5}}).reason(id), "fewer than three samples");
  }
}

TEST(LogDimensionlessJerk, IsNaForAConstantSpeed) {
  MeasuredRun run({{2, 5}, {3, 5}, {4, 5}, {5, 5}});
  for (Sample& sample : run.trajectory.samples) sample.v = 0.7;
  EXPECT_EQ(run.reason("log_dimensionless_jerk"), "zero jerk");
}

TEST(Smoothness, IsNaForALogWithAHugeGap) {
  MeasuredRun run({{2, 5}, {3, 5}, {4, 5}, {5, 5}});
  for (Sample& sample : run.trajectory.samples) sample.v = 0.7;
  run.trajectory.samples.back().t = 1e12;
  EXPECT_EQ(run.reason("sparc"), "more than 1048576 median intervals");
}

}  // namespace
}  // namespace slalom::testing
