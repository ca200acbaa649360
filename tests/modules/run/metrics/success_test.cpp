// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(Success, IsOneForSuccessOnly) {
  MeasuredRun run({{2, 5}, {8, 5}});
  for (const Outcome outcome : enum_values<Outcome>()) {
    run.outcome = outcome;
    if (outcome == Outcome::UnsolvableScenario || outcome == Outcome::InfrastructureError) {
      EXPECT_EQ(run.reason("success"), "outcome: " + to_string(outcome));
    } else {
      EXPECT_EQ(run.number("success"), outcome == Outcome::Success ? 1 : 0) << to_string(outcome);
    }
  }
}

TEST(Success, IsZeroWithoutMotion) {
  MeasuredRun run({{2, 5}, {2, 5}});
  run.outcome = Outcome::Stuck;
  EXPECT_EQ(run.number("success"), 0);
}

TEST(SoftSpl, IsTheCompletedFractionOfTheDistanceToTheGoal) {
  MeasuredRun run({{2, 5}, {5, 5}});
  run.outcome = Outcome::Timeout;
  EXPECT_NEAR(run.number("soft_spl"), 0.5, 1e-12);  // 3 m of 6 m, no detour
}

TEST(SoftSpl, IsReducedByADetour) {
  // 3 m forward, 3 m sideways and back: 9 m instead of 6 m, half of the distance.
  MeasuredRun run({{2, 5}, {5, 5}, {5, 8}, {5, 5}});
  run.outcome = Outcome::Stuck;
  EXPECT_NEAR(run.number("soft_spl"), 0.5 * 6 / 9, 1e-12);
}

TEST(SoftSpl, IsZeroWithoutMotionOrProgress) {
  for (const Path& path : {Path{{2, 5}, {2, 5}}, Path{{2, 5}, {0, 5}}}) {
    MeasuredRun run(path);
    run.outcome = Outcome::Timeout;
    EXPECT_EQ(run.number("soft_spl"), 0);
  }
}

TEST(SoftSpl, IsNaIfTheFailureIsNotAttributableToTheMethod) {
  MeasuredRun run({{2, 5}});
  run.outcome = Outcome::UnsolvableScenario;
  EXPECT_EQ(run.reason("soft_spl"), "outcome: unsolvable_scenario");
  EXPECT_EQ(run.reason("barn_score_v2"), "outcome: unsolvable_scenario");
}

/// 6 m at 1 m/s: at least 6 s.
struct RunOf : MeasuredRun {
  explicit RunOf(double seconds) : MeasuredRun({{2, 5}, {8, 5}}) {
    trajectory.samples.back().t = seconds;
  }
};

TEST(BarnScore, IsTheClippedRatioToTheBestTime) {
  EXPECT_NEAR(RunOf(6).number("barn_score_v2"), 0.5, 1e-12);  // clipped at twice the best
  EXPECT_NEAR(RunOf(12).number("barn_score_v2"), 0.5, 1e-12);
  EXPECT_NEAR(RunOf(24).number("barn_score_v2"), 0.25, 1e-12);
  EXPECT_NEAR(RunOf(100).number("barn_score_v2"), 0.125, 1e-12);  // at eight times
}

TEST(BarnScore, OfAFailureIsZero) {
  RunOf run(12);
  run.outcome = Outcome::Collision;
  EXPECT_EQ(run.number("barn_score_v2"), 0);
}

}  // namespace
}  // namespace slalom::testing
