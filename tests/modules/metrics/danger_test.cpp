#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(RiskTimeRatio, CountsAnIntervalThatIsOpenWhenTheLogEnds) {
  // Clearance 1.75 m for 0.1 s, then at once down to 0.25 m and there to the end of the log.
  const MeasuredRun run({{2, 2}, {3, 2}, {3, 0.5}, {4, 0.5}, {5, 0.5}});
  // From 1.75 m to 0.25 m the last sixth lies below 0.5 m; then two whole intervals of four.
  EXPECT_NEAR(run.number("risk_time_ratio"), (1.0 / 6 + 2) / 4, 1e-9);
}

TEST(RiskTimeRatio, WeighsByTimeNotBySamples) {
  MeasuredRun run({{2, 0.5}, {3, 0.5}, {3, 2}, {3, 2}});
  run.trajectory.samples[1].t = 6;
  run.trajectory.samples[2].t = 6 + 1e-9;
  run.trajectory.samples[3].t = 8;
  EXPECT_NEAR(run.number("risk_time_ratio"), 0.75, 1e-8);
}

TEST(RiskTimeRatio, DependsOnTheSafeDistance) {
  MeasuredRun run({{2, 1}, {3, 1}});  // clearance 0.75 m
  EXPECT_EQ(run.number("risk_time_ratio"), 0);
  run.safe_distance = 0.8;
  EXPECT_EQ(run.number("risk_time_ratio"), 1);
}

TEST(RiskTimeRatio, WithoutTimeIsNotAvailable) {
  EXPECT_EQ(MeasuredRun({{2, 0.3}}).reason("risk_time_ratio"), "no time passed");
  EXPECT_EQ(MeasuredRun({{2, 0.3}}).reason("inverse_clearance"), "no time passed");
}

TEST(InverseClearance, IsAMeanOverTime) {
  MeasuredRun run({{2, 0.75}, {3, 0.75}, {3, 2.25}, {4, 2.25}});  // 0.5 m, then 2 m
  run.trajectory.samples[1].t = 3;
  run.trajectory.samples[2].t = 3 + 1e-9;
  run.trajectory.samples[3].t = 4;
  EXPECT_NEAR(run.number("inverse_clearance"), (3 * 2 + 1 * 0.5) / 4, 1e-7);
}

TEST(InverseClearance, AtAContactIsFinite) {
  EXPECT_NEAR(MeasuredRun({{2, 0.25}, {3, 0.25}}).number("inverse_clearance"), 100, 1e-9);
}

}  // namespace
}  // namespace slalom::testing
