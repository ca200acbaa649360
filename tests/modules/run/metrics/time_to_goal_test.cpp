// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(TimeToGoal, IsTheTimeFromTheFirstSampleToTheLast) {
  MeasuredRun run({{2, 5}, {5, 5}, {8, 5}});
  run.trajectory.samples[0].t = 10;  // a log may start at any time
  run.trajectory.samples[1].t = 11;
  run.trajectory.samples[2].t = 12.5;
  EXPECT_DOUBLE_EQ(run.number("time_to_goal"), 2.5);
}

TEST(TimeToGoal, IsZeroForARunThatStartsAtItsGoal) {
  EXPECT_EQ(MeasuredRun({{8, 5}}).number("time_to_goal"), 0);
}

TEST(Par2Time, IsTheTimeOfASuccessAndTwiceTheLimitOfAFailure) {
  MeasuredRun run({{2, 5}, {5, 5}, {8, 5}});  // T_max is 60 s
  EXPECT_DOUBLE_EQ(run.number("par2_time"), 0.2);
  run.outcome = Outcome::Collision;
  EXPECT_EQ(run.number("par2_time"), 120);
  run.outcome = Outcome::InfrastructureError;
  EXPECT_EQ(run.reason("par2_time"), "outcome: infrastructure_error");
}

TEST(TimeRatio, IsRelativeToTheShortestPathAtMaximumSpeed) {
  MeasuredRun run({{2, 5}, {5, 5}, {8, 5}});
  run.trajectory.samples[1].t = 4;
  run.trajectory.samples[2].t = 9;
  run.robot.max_v = 2;  // 6 m take 3 s
  EXPECT_DOUBLE_EQ(run.number("time_ratio"), 3);
}

TEST(TimeRatio, IsNaForARunThatStartsAtItsGoal) {
  EXPECT_EQ(MeasuredRun({{8, 5}}).reason("time_ratio"), "zero duration");
}

}  // namespace
}  // namespace slalom::testing
