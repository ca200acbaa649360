// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(MinClearance, IsTheMinimumOfTheFootprint) {
  EXPECT_NEAR(MeasuredRun({{2, 5}, {4, 1}, {8, 5}}).number("min_clearance"), 1 - 0.25, 1e-9);
}

TEST(MinClearance, IsZeroAtAContact) {
  MeasuredRun run({{2, 5}, {2, 0.25}});
  run.outcome = Outcome::Collision;
  EXPECT_NEAR(run.number("min_clearance"), 0, 1e-9);
}

TEST(MeanClearance, WeighsByLength) {
  // 3 m along y = 3, then up to y = 4 in 1 m: (3 * 3 + 1 * 3.5) / 4 - 0.25.
  EXPECT_NEAR(MeasuredRun({{2, 3}, {5, 3}, {5, 4}}).number("mean_clearance"), 12.5 / 4 - 0.25,
              1e-9);
}

TEST(MeanClearance, IgnoresStops) {
  EXPECT_NEAR(MeasuredRun({{2, 1}, {2, 1}, {2, 1}, {2, 3}}).number("mean_clearance"), 2 - 0.25,
              1e-9);
}

TEST(MeanClearance, IsNaWithoutMotion) {
  MeasuredRun run({{2, 5}, {2, 5}});
  run.outcome = Outcome::Stuck;
  EXPECT_EQ(run.reason("mean_clearance"), "the robot did not move");
  EXPECT_NEAR(run.number("min_clearance"), 5 - 0.25, 1e-9);
}

TEST(MinClearance, OfAPolygonDependsOnItsHeading) {
  // 0.8 m long, 0.4 m wide, 1 m above the lower wall: clearance 0.8 m parallel to it, 0.6 m across.
  MeasuredRun run({{2, 1}, {3, 1}});
  run.robot.footprint = "0.4,0.2; -0.4,0.2; -0.4,-0.2; 0.4,-0.2";
  EXPECT_NEAR(run.number("min_clearance"), 0.8, 1e-9);
  for (Sample& sample : run.trajectory.samples) sample.pose.phi = M_PI / 2;
  EXPECT_NEAR(run.number("min_clearance"), 0.6, 1e-9);
}

TEST(RiskTimeRatio, CountsAnIntervalStillOpenAtTheEndOfTheLog) {
  // Clearance 1.75 m for 0.1 s, then within one interval to 0.25 m until the end of the log.
  const MeasuredRun run({{2, 2}, {3, 2}, {3, 0.5}, {4, 0.5}, {5, 0.5}});
  // From 1.75 m to 0.25 m the last sixth is below 0.5 m; then two full intervals of four.
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

TEST(RiskTimeRatio, IsNaForZeroDuration) {
  EXPECT_EQ(MeasuredRun({{2, 0.3}}).reason("risk_time_ratio"), "zero duration");
  EXPECT_EQ(MeasuredRun({{2, 0.3}}).reason("inverse_clearance"), "zero duration");
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
