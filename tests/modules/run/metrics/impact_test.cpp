// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

/// A run that ends in contact with the lower wall.
struct Crash : MeasuredRun {
  Crash(double phi, double v, double w = 0) : MeasuredRun({{4, 1}, {4, 0.25}}) {
    outcome = Outcome::Collision;
    Sample& last = trajectory.samples.back();
    last.pose.phi = phi;
    last.v = v;
    last.w = w;
  }
};

TEST(ImpactSpeed, IsTheSpeedAlongTheContactNormal) {
  EXPECT_NEAR(Crash(-M_PI / 2, 0.8).number("impact_speed"), 0.8, 1e-9);
  EXPECT_NEAR(Crash(-M_PI / 6, 0.8).number("impact_speed"), 0.4, 1e-9);
  EXPECT_NEAR(Crash(0, 0.8).number("impact_speed"), 0, 1e-9);
  EXPECT_NEAR(Crash(M_PI / 2, -0.8).number("impact_speed"), 0.8, 1e-9);  // backward
}

TEST(ImpactSpeed, OfAHolonomicRobotIncludesBothDirections) {
  Crash run(0, 0.3);
  run.trajectory.samples.back().vy = -0.4;  // to the right: down
  EXPECT_NEAR(run.number("impact_speed"), 0.4, 1e-9);
}

TEST(ImpactSpeed, OfAPolygonIncludesItsRotation) {
  // Its right front corner is the lowest, and moves down at w times its horizontal lever.
  const double phi = -0.1, c = std::cos(phi), s = std::sin(phi);
  Crash run(phi, 0, -1);
  run.robot.footprint = "0.4,0.2; -0.4,0.2; -0.4,-0.2; 0.4,-0.2";
  run.trajectory.samples.back().pose = {4, 0.2 * c - 0.4 * s, phi};
  EXPECT_NEAR(run.number("impact_speed"), 0.4 * c + 0.2 * s, 1e-3);
}

TEST(ImpactSpeed, IsNaWithoutACollision) {
  MeasuredRun run({{2, 5}, {8, 5}});
  EXPECT_EQ(run.reason("impact_speed"), "outcome: success");
}

TEST(MinTimeToCollision, IsTheGapOverTheClosingSpeed) {
  // Down by 1 m in each 0.1 s, that is 10 m/s, to 0.75 m from the wall, then away.
  const MeasuredRun run({{4, 4}, {4, 3}, {4, 2}, {4, 1}, {4, 3}});
  EXPECT_NEAR(run.number("min_time_to_collision"), 0.75 / 10, 1e-9);
}

TEST(MinTimeToCollision, IsTheMinimumOverAllApproaches) {
  MeasuredRun run({{4, 4}, {4, 3}, {4, 5}, {4, 0.45}, {4, 0.35}});
  run.trajectory.samples[3].t = 100;
  run.trajectory.samples[4].t = 101;  // 0.1 m/s, 0.1 m remaining: 1 s; before: 2.75 m at 10 m/s
  EXPECT_NEAR(run.number("min_time_to_collision"), 0.275, 1e-9);
  run.trajectory.samples[4].t = 100.1;  // 1 m/s
  EXPECT_NEAR(run.number("min_time_to_collision"), 0.1, 1e-9);
}

TEST(MinTimeToCollision, IsNaIfTheClearanceNeverDecreases) {
  EXPECT_EQ(MeasuredRun({{2, 4}, {3, 4}, {4, 4.5}}).reason("min_time_to_collision"),
            "the clearance never decreased");
}

}  // namespace
}  // namespace slalom::testing
