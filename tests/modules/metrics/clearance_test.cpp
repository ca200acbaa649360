#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(MinClearance, IsThatOfTheFootprintAtItsNearest) {
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

TEST(MeanClearance, DoesNotCountStandingStill) {
  EXPECT_NEAR(MeasuredRun({{2, 1}, {2, 1}, {2, 1}, {2, 3}}).number("mean_clearance"), 2 - 0.25,
              1e-9);
}

TEST(MeanClearance, OfARobotThatNeverMovesIsNotAvailable) {
  MeasuredRun run({{2, 5}, {2, 5}});
  run.outcome = Outcome::Stuck;
  EXPECT_EQ(run.reason("mean_clearance"), "the robot did not move");
  EXPECT_NEAR(run.number("min_clearance"), 5 - 0.25, 1e-9);
}

TEST(MinClearance, OfAPolygonDependsOnItsHeading) {
  // 0.8 m long, 0.4 m wide, 1 m above the lower wall: along it 0.8 m are left, across it 0.6 m.
  MeasuredRun run({{2, 1}, {3, 1}});
  run.robot.footprint = "0.4,0.2; -0.4,0.2; -0.4,-0.2; 0.4,-0.2";
  EXPECT_NEAR(run.number("min_clearance"), 0.8, 1e-9);
  for (Sample& sample : run.trajectory.samples) sample.pose.phi = M_PI / 2;
  EXPECT_NEAR(run.number("min_clearance"), 0.6, 1e-9);
}

}  // namespace
}  // namespace slalom::testing
