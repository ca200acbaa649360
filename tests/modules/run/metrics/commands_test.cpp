// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

#include <array>

namespace slalom::testing {
namespace {

void command(MeasuredRun& run, const std::vector<std::array<double, 3>>& commands) {
  for (std::size_t i = 0; i < commands.size(); ++i) {
    run.trajectory.samples[i].command_v = commands[i][0];
    run.trajectory.samples[i].command_w = commands[i][1];
    run.trajectory.samples[i].command_vy = commands[i][2];
  }
}

TEST(CommandVariation, IsTheSumOfTheCommandChanges) {
  MeasuredRun run({{2, 5}, {2, 5}, {2, 5}, {2, 5}});
  command(run, {{1, 0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.25, 0}, {1, 0.25, 0}});
  EXPECT_NEAR(run.number("command_variation_v"), 1, 1e-12);
  EXPECT_NEAR(run.number("command_variation_w"), 1.75, 1e-12);
}

TEST(CommandVariation, OfAHolonomicRobotIsThatOfTheVelocity) {
  MeasuredRun run({{2, 5}, {2, 5}});
  command(run, {{0.5, 0, 0}, {0.8, 0, 0.4}});
  EXPECT_NEAR(run.number("command_variation_v"), 0.5, 1e-12);
}

TEST(CommandVariation, IsNaWithoutCommands) {
  MeasuredRun run({{2, 5}, {3, 5}});
  for (Sample& sample : run.trajectory.samples)
    sample.command_v = sample.command_w = sample.command_vy = std::nan("");
  EXPECT_EQ(run.reason("command_variation_v"), "no commands are recorded");
  EXPECT_EQ(run.reason("command_variation_w"), "no commands are recorded");
  EXPECT_EQ(MeasuredRun({{2, 5}}).reason("command_variation_v"), "zero duration");
}

TEST(OscillationCount, CountsSignChangesAboveAThreshold) {
  MeasuredRun run({{2, 5}, {2, 5}, {2, 5}, {2, 5}, {2, 5}, {2, 5}});
  const double w[] = {0.5, -0.05, 0.3, -0.4, 0, 0.2};  // left, left, right, left
  for (std::size_t i = 0; i < 6; ++i) run.trajectory.samples[i].w = w[i];
  EXPECT_EQ(run.number("oscillation_count"), 2);
}

TEST(OscillationCount, IsZeroForOneTurningDirection) {
  MeasuredRun run({{2, 5}, {2, 5}});
  for (Sample& sample : run.trajectory.samples) sample.w = -1;
  EXPECT_EQ(run.number("oscillation_count"), 0);
  EXPECT_EQ(MeasuredRun({{2, 5}}).reason("oscillation_count"), "zero duration");
}

}  // namespace
}  // namespace slalom::testing
