#include <slalom/campaign/campaign.h>
#include <slalom/core/error.h>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace slalom {
namespace {

/// Turns towards the goal and drives; misbehaves in the way its kind says, in the scenario whose
/// goal lies above y = 5.
class TestMethod : public Method {
 public:
  TestMethod(std::string kind, RobotModel robot) : kind_(std::move(kind)), robot_(robot) {}

  void reset(const Task& task) override { misbehaves_ = task.goal.y > 5; }

  Command step(const Observation& observation) override {
    if (misbehaves_ && observation.time > 0.5) misbehave();
    const double bearing = std::atan2(observation.goal_in_robot.y, observation.goal_in_robot.x);
    const double w = std::max(-robot_.max_w, std::min(robot_.max_w, 2 * bearing));
    return {std::abs(bearing) < 0.3 ? robot_.max_v : 0.0, w};
  }

 private:
  void misbehave() const {
    if (kind_ == "crash") std::raise(SIGSEGV);
    if (kind_ == "exit") std::exit(0);
    if (kind_ == "throw") throw std::runtime_error("lost my way");
    volatile bool forever = kind_ == "hang";
    while (forever) {
    }
  }

  std::string kind_;
  RobotModel robot_;
  bool misbehaves_ = false;
};

Scenario free_field(const std::string& name, double goal_y) {
  Primitives obstacles;
  obstacles.discs.push_back({{8, 5}, 0.5});
  return Scenario::continuous(name, {0, 0, 10, 10}, obstacles, {1, 1, 0}, {5, goal_y});
}

class RecordingSink : public CampaignSink {
 public:
  void add_scenario(const ScenarioRecord& record, const Scenario&, const References&) override {
    scenarios.push_back(record);
  }
  void add_run(const RunRecord& run, const RunTiming&, const Trajectory& trajectory) override {
    EXPECT_TRUE(trajectory.samples.empty() || trajectory.hash() == run.trajectory_hash);
    runs.push_back(run);
  }
  std::vector<ScenarioRecord> scenarios;
  std::vector<RunRecord> runs;
};

class CampaignTest : public testing::Test {
 protected:
  CampaignTest() {
    registry_.add("test", [](const MethodContext& context) -> std::unique_ptr<Method> {
      const std::string kind = context.ini.get(context.section, "kind").value_or("good");
      if (kind == "unbuildable") throw usage_error(context.section, "no such thing", "a thing");
      if (kind == "deadly") std::abort();
      return std::make_unique<TestMethod>(kind, context.robot);
    });
  }

  IniFile ini_for(const std::vector<std::string>& kinds) const {
    std::string methods, sections;
    for (const std::string& kind : kinds) {
      methods += (methods.empty() ? "" : ",") + kind;
      sections += "[method." + kind + "]\nadapter = test\nkind = " + kind + "\n";
    }
    return IniFile::from_text("[campaign]\nrepetitions = 2\nmethods = " + methods +
                              "\n[limits]\nrun_wall_time = 1\n" + sections);
  }

  RecordingSink run(const std::vector<std::string>& kinds, int workers) {
    const IniFile ini = ini_for(kinds);
    const Campaign campaign{read_campaign_options(ini),
                            {free_field("low", 3), free_field("high", 7)},
                            ini,
                            registry_,
                            nullptr};
    const auto progress = make_silent_progress();
    RecordingSink sink;
    const CampaignSummary summary = run_campaign(campaign, sink, {workers, *progress, nullptr});
    EXPECT_TRUE(summary.complete);
    EXPECT_EQ(summary.runs, sink.runs.size());
    return sink;
  }

  MethodRegistry registry_;
};

TEST_F(CampaignTest, EveryMethodMeetsEveryScenarioInTheOrderOfThePlan) {
  const RecordingSink sink = run({"good", "other"}, 2);
  ASSERT_EQ(sink.scenarios.size(), 2U);
  ASSERT_EQ(sink.runs.size(), 8U);  // 2 scenarios x 2 methods x 2 repetitions
  EXPECT_EQ(sink.runs[0].scenario_name, "low");
  EXPECT_EQ(sink.runs[0].method, "good");
  EXPECT_EQ(sink.runs[1].repetition, 1);
  EXPECT_EQ(sink.runs[2].method, "other");
  EXPECT_EQ(sink.runs[4].scenario_name, "high");
  for (const RunRecord& r : sink.runs) {
    EXPECT_EQ(r.outcome, "success") << r.outcome_detail;
    EXPECT_EQ(r.metrics.at("success").value.number(), 1);
  }
}

TEST_F(CampaignTest, MethodsMeetTheSameSeedsInTheSamePlace) {
  const RecordingSink sink = run({"good", "other"}, 1);
  EXPECT_EQ(sink.runs[0].seed, sink.runs[2].seed);
  EXPECT_NE(sink.runs[0].seed, sink.runs[1].seed);
  EXPECT_NE(sink.runs[0].seed, sink.runs[4].seed);
}

TEST_F(CampaignTest, WhateverAMethodDoesEndsOnlyItsRun) {
  const RecordingSink sink = run({"crash", "exit", "throw", "hang", "good"}, 2);
  ASSERT_EQ(sink.runs.size(), 20U);
  const std::map<std::string, std::string> expected = {{"crash", "method_crash"},
                                                       {"exit", "method_crash"},
                                                       {"throw", "method_error"},
                                                       {"hang", "method_deadline"},
                                                       {"good", "success"}};
  for (const RunRecord& r : sink.runs) {
    EXPECT_EQ(r.outcome, r.scenario_name == "low" ? "success" : expected.at(r.method)) << r.method;
    if (r.outcome == "success") continue;
    EXPECT_EQ(r.metrics.at("success").value, Value::of(0));
    EXPECT_TRUE(r.metrics.at("optimality").value.is_na());
    EXPECT_FALSE(r.outcome_detail.empty());
  }
}

TEST_F(CampaignTest, ResultsDoNotDependOnTheNumberOfWorkersNorOnOtherMethods) {
  const auto values_of_good = [](const RecordingSink& sink) {
    std::vector<std::pair<std::string, std::map<std::string, Value>>> values;
    for (const RunRecord& r : sink.runs) {
      if (r.method != "good") continue;
      values.emplace_back(r.trajectory_hash, std::map<std::string, Value>());
      for (const auto& [id, value] : r.metrics) values.back().second.emplace(id, value.value);
    }
    return values;
  };
  const auto alone = values_of_good(run({"good"}, 1));
  EXPECT_EQ(alone, values_of_good(run({"good"}, 3)));
  EXPECT_EQ(alone, values_of_good(run({"crash", "good"}, 2)));
}

TEST_F(CampaignTest, AScenarioWithoutAPathIsNotHeldAgainstTheMethod) {
  const IniFile ini = ini_for({"good"});
  Primitives wall;
  wall.polygons.push_back({{{4, 0}, {5, 0}, {5, 10}, {4, 10}}});
  const Scenario walled = Scenario::continuous("walled", {0, 0, 10, 10}, wall, {1, 5, 0}, {9, 5});
  const Campaign campaign{read_campaign_options(ini), {walled}, ini, registry_, nullptr};
  const auto progress = make_silent_progress();
  RecordingSink sink;
  run_campaign(campaign, sink, {1, *progress, nullptr});
  ASSERT_EQ(sink.runs.size(), 2U);
  EXPECT_EQ(sink.runs[0].outcome, "unsolvable_scenario");
  EXPECT_TRUE(sink.runs[0].metrics.at("success").value.is_na());
}

TEST_F(CampaignTest, AMethodThatCannotBeBuiltIsReportedBeforeAnythingRuns) {
  const auto message_for = [this](const std::string& kind) -> std::string {
    const IniFile ini = ini_for({"good", kind});
    const Campaign campaign{read_campaign_options(ini), {}, ini, registry_, nullptr};
    try {
      check_methods(campaign);
    } catch (const Error& e) {
      EXPECT_EQ(e.exit_status(), 2);
      return e.what();
    }
    return "no error";
  };
  EXPECT_EQ(message_for("good2"), "no error");
  EXPECT_EQ(message_for("unbuildable"), "method.unbuildable: no such thing; expected a thing");
  EXPECT_NE(message_for("deadly").find("the method could not be built: killed by signal 6"),
            std::string::npos);
}

}  // namespace
}  // namespace slalom
