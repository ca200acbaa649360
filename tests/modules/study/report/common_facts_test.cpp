// SPDX-License-Identifier: BSD-3-Clause
#include "common_facts.h"
#include "report_sample.h"

namespace slalom {
namespace {

/// Runs of a robot of radius 0.25 m in an empty room of 10 m, from (1, 1) to (9, 9).
class FactsOfFailures : public testing::Test {
 protected:
  FactsOfFailures()
      : content_{0,
                 0,
                 Scenario::continuous("room", {0, 0, 10, 10}, {{{{5, 5}, 0.5}}, {}}, {1, 1, 0}, {9, 9}),
                 {},
                 {},
                 {},
                 {}},
        world_(content_.content, 0.05),
        facts_(2, RobotModel()) {
    content_.references.shortest = ShortestPath{{{1, 1}, {9, 9}}, 11.4, {11.4, 11.4}, "exact", ""};
  }

  /// A run of 10 s along a line at 0.1 s per sample, turning at this rate, then standing for 6 s.
  static Trajectory run_along(double from, double to, double turn = 0) {
    Trajectory trajectory;
    for (int i = 0; i <= 160; ++i) {
      Sample sample;
      sample.t = i / 10.0;
      const double at = from + (to - from) * std::min(i, 100) / 100;
      sample.pose = {at, at, turn * sample.t};
      trajectory.samples.push_back(sample);
    }
    return trajectory;
  }

  void add(std::size_t method, Outcome outcome, const Trajectory& trajectory, int times = 1) {
    RunRecord run;
    run.outcome = to_string(outcome);
    content_.records = {run};
    content_.trajectories = {trajectory};
    for (int i = 0; i < times; ++i) facts_.add(method, content_, world_, 0);
  }

  std::string text(std::size_t method) const {
    const auto common = facts_.of(method);
    return common ? std::to_string(common->count) + " of " + std::to_string(common->failures) +
                        " " + common->text
                  : "";
  }

  ScenarioRuns content_;
  World world_;
  CommonFacts facts_;
};

TEST_F(FactsOfFailures, OfFewerThanThreeFailuresOrLessThanHalfOfThemAreNotNamed) {
  add(0, Outcome::Success, run_along(1, 9), 9);
  add(0, Outcome::Stuck, run_along(1, 1, 1), 2);
  EXPECT_EQ(text(0), "");
  add(0, Outcome::Timeout, run_along(1, 1, -1));
  EXPECT_EQ(text(0), "3 of 3 turn in place at their end: does it see what it turns to?");
  add(0, Outcome::Stuck, {});
  add(0, Outcome::Collision, run_along(3, 4), 2);
  EXPECT_EQ(text(0).substr(0, 12), "3 of 6 turn ");
  add(0, Outcome::Collision, run_along(3, 4));
  EXPECT_EQ(text(0), "") << "3 of 7";
  EXPECT_EQ(text(1), "");
}

TEST_F(FactsOfFailures, AreThoseThatOtherMethodsFailuresDoNotHave) {
  // Both stop in the open; those of the first method within 8 radii, 2 m, of the goal.
  add(0, Outcome::Stuck, run_along(2, 7.7), 4);
  add(1, Outcome::Stuck, run_along(2, 7.4), 4);
  EXPECT_EQ(text(0), "4 of 4 end within 2 m of the goal");
  EXPECT_EQ(text(1), "4 of 4 stop 0.25 m or more from every static obstacle");
}

TEST_F(FactsOfFailures, TellStopsAtObstaclesAtTheStartAndDetours) {
  // The disc of 0.5 m at (5, 5): on the diagonal at 4.4 the center is 0.8485 m from its center, so
  // that 0.0985 m are free, less than half a radius.
  add(0, Outcome::Stuck, run_along(2.5, 4.4), 3);
  EXPECT_EQ(text(0), "3 of 3 stop less than 0.13 m from a static obstacle");
  CommonFacts start(1, RobotModel());
  std::swap(facts_, start);
  add(0, Outcome::Timeout, run_along(1, 1.5), 3);
  EXPECT_EQ(text(0).substr(0, 23), "3 of 3 hardly leave the");
  CommonFacts detour(1, RobotModel());
  std::swap(facts_, detour);
  Trajectory wander;  // 12 m there and back, twice: 24 m > 2 * 11.4 m
  for (int i = 0; i <= 480; ++i) {
    Sample sample;
    sample.t = i / 10.0;
    const int phase = i % 240;
    sample.pose = {2 + 0.05 * (phase < 120 ? phase : 240 - phase), 2, 0};
    wander.samples.push_back(sample);
  }
  add(0, Outcome::Timeout, wander, 3);
  EXPECT_EQ(text(0), "3 of 3 wander: more than twice the reference path");
}

class FailuresReport : public ReportTest {};

TEST_F(FailuresReport, NamesAMethodThatTurnsInPlaceWhereItFails) {
  turn_ = 1;
  write(make_results(4));
  EXPECT_EQ(report_json()["overview"][1]["in_common"]["text"],
            "turn in place at their end: does it see what it turns to?");
  EXPECT_NE(read("index.html").find("<b>4 of 4</b> turn in place at their end: does it see what"),
            std::string::npos);
  turn_ = 0;
  write(make_results(4));
  EXPECT_EQ(read("report.json").find("turn in place"), std::string::npos);
}

}  // namespace
}  // namespace slalom
