#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(Success, IsOneForSuccessOnly) {
  MeasuredRun run({{2, 5}, {8, 5}});
  for (const Outcome outcome : all_outcomes()) {
    run.outcome = outcome;
    if (outcome == Outcome::UnsolvableScenario || outcome == Outcome::InfrastructureError) {
      EXPECT_EQ(run.reason("success"), "outcome: " + to_string(outcome));
    } else {
      EXPECT_EQ(run.number("success"), outcome == Outcome::Success ? 1 : 0) << to_string(outcome);
    }
  }
}

TEST(Success, IsZeroForARobotThatNeverMoves) {
  MeasuredRun run({{2, 5}, {2, 5}});
  run.outcome = Outcome::Stuck;
  EXPECT_EQ(run.number("success"), 0);
}

}  // namespace
}  // namespace slalom::testing
