// SPDX-License-Identifier: BSD-3-Clause
#include "report_sample.h"
#include "turning_in_place.h"

namespace slalom {
namespace {

/// A run of 10 s that stands and turns at this rate.
Trajectory run_that_turns(double rate) {
  Trajectory trajectory;
  for (int i = 0; i <= 100; ++i) {
    Sample sample;
    sample.t = i / 10.0;
    sample.pose.phi = rate * sample.t;
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

RunRecord run_with(Outcome outcome) {
  RunRecord run;
  run.outcome = to_string(outcome);
  return run;
}

TEST(TurningInPlace, IsNamedFromThreeAndHalfOfTheFailuresOn) {
  TurningInPlace turning(2, RobotModel());
  const auto add = [&](Outcome outcome, double rate) {
    turning.add(1, run_with(outcome), run_that_turns(rate));
  };
  for (int i = 0; i < 9; ++i) add(Outcome::Success, i % 2);
  for (int i = 0; i < 2; ++i) add(Outcome::Stuck, 1);
  EXPECT_EQ(turning.line_of(1), "");
  add(Outcome::Timeout, -1);
  EXPECT_EQ(turning.line_of(1),
            "turns in place at the end of 3 of 3 failures: does it see what it turns to?");
  turning.add(1, run_with(Outcome::Stuck), {});
  add(Outcome::Collision, 1);
  add(Outcome::Stuck, 0.1);
  EXPECT_NE(turning.line_of(1).find("3 of 6 failures"), std::string::npos);
  add(Outcome::Stuck, 0);
  EXPECT_EQ(turning.line_of(1), "");
  EXPECT_EQ(turning.line_of(0), "");
}

class FailuresReport : public ReportTest {};

TEST_F(FailuresReport, NamesAMethodThatTurnsInPlaceWhereItFails) {
  turn_ = 1;
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
