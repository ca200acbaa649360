// SPDX-License-Identifier: BSD-3-Clause
#include "report_sample.h"
#include "turning_in_place.h"

namespace slalom {
namespace {

/// A run of 20 s at 10 samples per second, which drives straight and then turns in place for
/// `turning` s.
Trajectory run_that_turns_for(double turning) {
  constexpr double kEnd = 20;  // s
  Trajectory trajectory;
  for (int i = 0; i <= 10 * kEnd; ++i) {
    Sample sample;
    sample.t = i / 10.0;
    (sample.t > kEnd - turning ? sample.w : sample.v) = 0.5;
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

RunRecord run_with(Outcome outcome) {
  RunRecord run;
  run.outcome = to_string(outcome);
  return run;
}

TEST(TurningInPlace, IsMostOfTheLastEightSeconds) {
  EXPECT_TRUE(ends_turning_in_place(run_that_turns_for(8)));
  EXPECT_TRUE(ends_turning_in_place(run_that_turns_for(4.5)));
  EXPECT_FALSE(ends_turning_in_place(run_that_turns_for(3.5)));
  EXPECT_FALSE(ends_turning_in_place({}));
}

TEST(TurningInPlace, IsNoTurnOfAMovingRobotNorAStandstill) {
  Trajectory moving = run_that_turns_for(20), standing = moving, sideways = moving;
  for (Sample& sample : moving.samples) sample.v = 0.1;
  for (Sample& sample : sideways.samples) sample.vy = -0.1;
  for (Sample& sample : standing.samples) sample.w = 0.05;
  for (const Trajectory& one : {moving, standing, sideways})
    EXPECT_FALSE(ends_turning_in_place(one));
}

TEST(TurningInPlace, IsNamedFromThreeAndHalfOfTheFailuresOn) {
  TurningInPlace turning(2);
  const auto add = [&](Outcome outcome, double seconds) {
    turning.add(1, run_with(outcome), run_that_turns_for(seconds));
  };
  for (int i = 0; i < 9; ++i) add(Outcome::Success, i % 2 == 0 ? 8 : 0);
  for (int i = 0; i < 2; ++i) add(Outcome::Stuck, 8);
  turning.add(1, run_with(Outcome::Stuck), {});
  EXPECT_EQ(turning.line_of(1), "");
  add(Outcome::Timeout, 8);
  EXPECT_EQ(turning.line_of(1),
            "turns in place at the end of 3 of 3 failures: does it see what it turns to?");
  for (int i = 0; i < 3; ++i) add(Outcome::Collision, 0);
  EXPECT_NE(turning.line_of(1).find("3 of 6 failures"), std::string::npos);
  add(Outcome::Stuck, 0);
  EXPECT_EQ(turning.line_of(1), "");
  EXPECT_EQ(turning.line_of(0), "");
}

class FailuresReport : public ReportTest {};

TEST_F(FailuresReport, NamesAMethodThatTurnsInPlaceWhereItFails) {
  turn_ = 0.5;
  write(make_results(4));
  std::string found;
  const auto json = report_json();
  for (const auto& line : json["headlines"])
    if (line["method"] == 0) found += line["text"].get<std::string>();
  EXPECT_EQ(found,
            "<bad> turns in place at the end of 4 of 4 failures: does it see what it turns to?");
  turn_ = 0;
  write(make_results(4));
  EXPECT_EQ(read("report.json").find("turns in place"), std::string::npos);
}

}  // namespace
}  // namespace slalom
