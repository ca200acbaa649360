#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(TimeToGoal, IsTheTimeFromTheFirstSampleToTheLast) {
  MeasuredRun run({{2, 5}, {5, 5}, {8, 5}});
  run.trajectory.samples[0].t = 10;  // a log need not begin at zero
  run.trajectory.samples[1].t = 11;
  run.trajectory.samples[2].t = 12.5;
  EXPECT_DOUBLE_EQ(run.number("time_to_goal"), 2.5);
}

TEST(TimeToGoal, OfARunThatBeginsAtItsGoalIsZero) {
  EXPECT_EQ(MeasuredRun({{8, 5}}).number("time_to_goal"), 0);
}

}  // namespace
}  // namespace slalom::testing
