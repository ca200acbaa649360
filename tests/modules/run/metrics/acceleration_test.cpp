// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

/// Whole periods of sines, so that root mean squares are those of a sine: amplitude / sqrt 2.
Sample oscillating(double t) {
  Sample sample;
  sample.v = 0.5 - 0.4 * std::cos(2 * M_PI * t / 6);
  sample.w = 0.6 * std::sin(2 * M_PI * t / 4);
  return sample;
}

void expect_true_rates(const MeasuredRun& run) {
  const double k = 2 * M_PI / 6, l = 2 * M_PI / 4, root = std::sqrt(2);
  const auto expect_near = [&](const std::string& id, double expected) {
    EXPECT_NEAR(run.number(id), expected, 0.02 * expected) << id;
  };
  expect_near("rms_linear_acceleration", 0.4 * k / root);
  expect_near("rms_angular_acceleration", 0.6 * l / root);
  expect_near("rms_linear_jerk", 0.4 * k * k / root);
  expect_near("rms_angular_jerk", 0.6 * l * l / root);
}

TEST(Accelerations, DoNotDependOnTheSamplingRate) {
  for (const double hz : {10.0, 20.0, 50.0}) expect_true_rates(SampledRun(12, hz, oscillating));
}

TEST(Accelerations, DoNotDependOnUniformIntervals) {
  SampledRun run(12, 20, oscillating);
  auto& samples = run.trajectory.samples;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const double t = samples[i].t + (i % 2 == 0 ? 0.01 : -0.01);
    samples[i] = oscillating(t);
    samples[i].t = t;
  }
  expect_true_rates(run);
}

TEST(Accelerations, IgnoreAFinalSampleAfterAVeryShortInterval) {
  SampledRun run(12, 10, oscillating);
  Sample last = run.trajectory.samples.back();
  last.t += 1e-7;
  last.v += 1e-3;
  run.trajectory.samples.push_back(last);
  expect_true_rates(run);
}

TEST(Jerk, OfAConstantAccelerationIsZero) {
  const SampledRun run(3, 10, [](double t) {
    Sample sample;
    sample.v = 0.7 * t;
    sample.w = -0.2 * t;
    return sample;
  });
  EXPECT_NEAR(run.number("rms_linear_acceleration"), 0.7, 1e-9);
  EXPECT_NEAR(run.number("rms_angular_acceleration"), 0.2, 1e-9);
  EXPECT_NEAR(run.number("rms_linear_jerk"), 0, 1e-9);
  EXPECT_NEAR(run.number("rms_angular_jerk"), 0, 1e-9);
}

TEST(Accelerations, OfAHolonomicRobotAreThoseOfItsSpeed) {
  // (v, vy) rotates, with a magnitude of 0.5 m/s that increases by 0.1 m/s each second.
  SampledRun run(4, 10, [](double t) {
    Sample sample;
    sample.v = (0.5 + 0.1 * t) * std::cos(3 * t);
    sample.vy = (0.5 + 0.1 * t) * std::sin(3 * t);
    return sample;
  });
  EXPECT_NEAR(run.number("rms_linear_acceleration"), 0.1, 1e-9);
}

TEST(Accelerations, NeedTwoSamplesAndJerksThree) {
  EXPECT_EQ(MeasuredRun({{2, 5}}).reason("rms_linear_acceleration"), "zero duration");
  EXPECT_EQ(MeasuredRun({{2, 5}, {3, 5}}).reason("rms_linear_jerk"), "fewer than three samples");
  EXPECT_EQ(MeasuredRun({{2, 5}, {3, 5}}).number("rms_angular_acceleration"), 0);
}

}  // namespace
}  // namespace slalom::testing
