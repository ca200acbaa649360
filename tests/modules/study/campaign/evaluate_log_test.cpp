// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/evaluate_log.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace slalom {
namespace {

/// A log at 1 m/s along y = 5 m, one sample per second.
Trajectory straight_log(double from, double to) {
  Trajectory log;
  for (double x = from; x <= to; ++x) {
    Sample sample;
    sample.t = x - from;
    sample.pose = {x, 5, 0};
    sample.v = 1;
    log.samples.push_back(sample);
  }
  return log;
}

class EvaluateLog : public testing::Test {
 protected:
  EvaluatedLog evaluated(const Trajectory& log,
                         std::optional<Outcome> outcome = std::nullopt) const {
    CampaignOptions options;
    options.metrics = {"path_length", "time_to_goal"};
    return evaluate_log(options, nullptr, world_, log, outcome);
  }
  const World world_{Scenario::continuous("room", {0, 0, 10, 10}, {}, {2, 5, 0}, {6, 5}), 0.05};
};

TEST_F(EvaluateLog, EndsAtTheGoalAndTellsWhatIsLeftOut) {
  const EvaluatedLog log = evaluated(straight_log(2, 8));
  EXPECT_EQ(log.run.outcome, Outcome::Success);
  EXPECT_NEAR(log.metrics.at("path_length").value.number(), 3.8, 0.05);  // to the tolerance
  ASSERT_EQ(log.notes.size(), 1U);
  // Evaluated in steps of 1 cm.
  EXPECT_EQ(log.notes[0].find("the last 2.19 s of the log are left out: goal reached"), 0U)
      << log.notes[0];
}

TEST_F(EvaluateLog, IsCompleteIfItsOutcomeIsGiven) {
  const EvaluatedLog log = evaluated(straight_log(2, 8), Outcome::Stuck);
  EXPECT_EQ(log.run.detail, "as given");
  EXPECT_NEAR(log.metrics.at("path_length").value.number(), 6, 1e-12);
  EXPECT_TRUE(log.metrics.at("time_to_goal").value.is_na());
  EXPECT_TRUE(log.notes.empty());
}

TEST_F(EvaluateLog, NotesThatALogThatWasStuckReachesTheGoal) {
  Trajectory log = straight_log(2, 6);
  for (Sample& sample : log.samples) sample.t += 20;
  for (int t = 0; t < 20; ++t) {  // stands before it drives
    Sample sample = log.samples[static_cast<std::size_t>(t)];
    sample.t = t;
    sample.pose = {2, 5, 0};
    log.samples.insert(log.samples.begin() + t, sample);
  }
  const EvaluatedLog evaluated_log = evaluated(log);
  EXPECT_EQ(evaluated_log.run.outcome, Outcome::Stuck);
  EXPECT_EQ(evaluated_log.notes.back().find("the log reaches the goal"), 0U)
      << evaluated_log.notes.back();
}

TEST_F(EvaluateLog, ALogThatStandsAtAGoalWithAnotherHeadingDoesNotReachIt) {
  Trajectory log = straight_log(2, 8);
  for (int t = 1; t <= 20; ++t) {
    Sample sample = log.samples.back();
    sample.t += 1;
    log.samples.push_back(sample);
  }
  const World turned(world_.scenario().with_start_goal({2, 5, 0}, {8, 5}).with_goal_heading(2),
                     0.05);
  const EvaluatedLog result = evaluate_log({}, nullptr, turned, log, std::nullopt);
  EXPECT_EQ(result.run.outcome, Outcome::Stuck);
  for (const std::string& note : result.notes)
    EXPECT_EQ(note.find("the log reaches the goal"), std::string::npos) << note;
}

TEST_F(EvaluateLog, NotesThatItBeginsElsewhere) {
  const EvaluatedLog log = evaluated(straight_log(3, 5), Outcome::Timeout);
  ASSERT_EQ(log.notes.size(), 1U);
  EXPECT_EQ(log.notes[0].find("the log begins 1.00 m from the scenario's start"), 0U);
}

TEST_F(EvaluateLog, JsonHasValuesReasonsAndVersions) {
  const EvaluatedLog log = evaluated(straight_log(2, 8), Outcome::Stuck);
  const auto json = nlohmann::json::parse(render_json(log, world_.scenario()));
  EXPECT_EQ(json["scenario"]["hash"], world_.scenario().hash());
  EXPECT_EQ(json["outcome"], "stuck");
  EXPECT_EQ(json["trajectory"], log.run.trajectory.hash());
  EXPECT_EQ(json["metrics"]["path_length"]["version"], log.metrics.at("path_length").version);
  EXPECT_EQ(json["metrics"]["time_to_goal"]["na"], log.metrics.at("time_to_goal").value.reason());
}

}  // namespace
}  // namespace slalom
