// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(MeanSpeed, IsLengthOverTime) {
  MeasuredRun run({{2, 5}, {5, 5}, {5, 9}});
  run.trajectory.samples.back().t = 3.5;
  EXPECT_DOUBLE_EQ(run.number("mean_speed"), 2);
  EXPECT_EQ(MeasuredRun({{2, 5}}).reason("mean_speed"), "zero duration");
}

TEST(TimeStopped, WeighsByTimeAndCountsToTheEndOfTheLog) {
  MeasuredRun run({{2, 5}, {3, 5}, {3, 5}, {3, 5}});
  run.trajectory.samples[0].v = 1;
  run.trajectory.samples[1].v = 1;
  run.trajectory.samples[2].t = 0.3;
  run.trajectory.samples[3].t = 2.3;  // stopped from 0.3 s on, and half of the time since 0.1 s
  EXPECT_NEAR(run.number("time_stopped"), 2.1, 1e-12);
}

TEST(TimeStopped, OfARobotWithoutMotionIsTheDuration) {
  MeasuredRun run({{2, 5}, {2, 5}, {2, 5}});
  EXPECT_NEAR(run.number("time_stopped"), 0.2, 1e-12);
}

TEST(TimeStopped, IgnoresRotationInPlaceAndLateralMotion) {
  MeasuredRun run({{2, 5}, {2, 5}, {2, 5}});
  for (Sample& sample : run.trajectory.samples) sample.w = 0.5;
  EXPECT_EQ(run.number("time_stopped"), 0);
  for (Sample& sample : run.trajectory.samples) sample.w = 0, sample.vy = -0.5;
  EXPECT_EQ(run.number("time_stopped"), 0);
}

}  // namespace
}  // namespace slalom::testing
