// SPDX-License-Identifier: BSD-3-Clause
#include "repeated_runs.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// Three samples, at 0, 0.5 and 1 s.
Trajectory three_samples() {
  Trajectory trajectory;
  for (int i = 0; i < 3; ++i) {
    Sample sample;
    sample.t = 0.5 * i;
    sample.pose = {0.1 * i, 0, 0};
    sample.command_v = 0.2;
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

std::string difference(const Trajectory& before, const Trajectory& now) {
  RunRecord record;
  record.trajectory_hash = before.hash();
  ExecutedRun again{record, now};
  again.record.trajectory_hash = now.hash();
  return execution_difference(record, &before, again);
}

TEST(RepeatedRuns, AreComparedBySamplesInTheOrderOfTimeThenOfTheFields) {
  const Trajectory before = three_samples();
  EXPECT_EQ(difference(before, before), "");
  Trajectory now = before;
  now.samples[2].pose.x = 7;
  now.samples[1].command_v = 0.25;
  now.samples[1].command_w = 1;
  EXPECT_EQ(difference(before, now), "differs after 0.50 s: command v 0.2 and 0.25 m/s");
}

TEST(RepeatedRuns, AFieldThatIsUnknownTwiceDoesNotDiffer) {
  Trajectory before = three_samples(), now = before;
  ASSERT_NE(before.samples[0].traveled, before.samples[0].traveled) << "NaN";
  now.samples[2].w = 0.5;
  EXPECT_EQ(difference(before, now), "differs after 1.00 s: w 0 and 0.5 rad/s");
}

TEST(RepeatedRuns, OneThatEndsEarlierDiffersAtItsEnd) {
  const Trajectory longer = three_samples();
  Trajectory shorter = longer;
  shorter.samples.pop_back();
  const std::string text = "differs after 0.50 s: one execution ends there, the other after 1.00 s";
  EXPECT_EQ(difference(longer, shorter), text);
  EXPECT_EQ(difference(shorter, longer), text);
}

TEST(RepeatedRuns, AreComparedByTheirValuesWithoutTrajectories) {
  RunRecord before;
  before.outcome = "success";
  ExecutedRun again{before, {}};
  EXPECT_EQ(execution_difference(before, nullptr, again), "");
  again.record.outcome = "collision";
  EXPECT_EQ(execution_difference(before, nullptr, again).find("differs: /"), 0U);
  EXPECT_EQ(line_difference(R"({"a":1,"b":2})", R"({"a":2,"b":3})"),
            "/a was 1 and is 2, and 1 more value");
}

}  // namespace
}  // namespace slalom
