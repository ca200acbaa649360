// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "shared_count.h"

#include <slalom/campaign/run_campaign.h>
#include <slalom/campaign/run_draws.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <stdexcept>
#include <unistd.h>
#include <vector>

namespace slalom {
namespace {

/// Drives straight ahead at its maximum velocity; its process ends in scenarios whose goal has
/// y > 2.05.
class Ahead : public Method {
 public:
  explicit Ahead(double v) : v_(v) {}
  void reset(const NavigationTask& task) override { ends_ = task.goal.y > 2.05; }
  Command step(const Observation&) override {
    if (ends_) std::_Exit(3);
    return {v_, 0};
  }

 private:
  double v_;
  bool ends_ = false;
};

NamedMethod ahead() {
  return {"ahead",
          [](const RobotModel& robot, const SensorModel&) {
            return std::make_unique<Ahead>(robot.max_v);
          },
          ""};
}

CampaignOptions options_of_draws() {
  CampaignOptions options;
  options.metrics = {"success"};
  options.descriptors = {"density"};
  options.simulation.max_time = 5;
  options.odometry.distance_sigma = 0.1;  // the seed of a run matters
  options.seed = 7;
  return options;
}

/// A corridor; every third has a wall in front of the goal.
Scenario corridor(std::size_t index, double goal_y = 2) {
  Primitives walls;
  if (index % 3 == 0) walls.polygons = {{{{2, 1}, {2.2, 1}, {2.2, 3}, {2, 3}}}};
  return Scenario::continuous("corridor_" + std::to_string(index),
                              {0, 0, 4 + 0.1 * static_cast<double>(index), 4}, std::move(walls),
                              {1, 2, 0}, {3, goal_y});
}

std::optional<RunDraw> draw_corridor(std::size_t index) {
  return RunDraw{corridor(index)};
}

std::vector<DrawnRun> runs_of(const DrawRun& draw, std::size_t count, int workers,
                              std::size_t wanted = 1000) {
  std::vector<DrawnRun> runs;
  const auto receive = [&](const DrawnRun& run) {
    runs.push_back(run);
    return runs.size() < wanted;
  };
  EXPECT_TRUE(run_draws(ahead(), options_of_draws(), draw, count, {workers}, receive));
  return runs;
}

class OutcomeSink : public CampaignSink {
 public:
  void add_scenario(const ScenarioRecord&, const References&, const PackedScenario&) override {}
  void add_run(const RunRecord& run, const RunTiming&, const PackedTrajectory&) override {
    runs[run.scenario_hash] = run;
  }
  std::map<std::string, RunRecord> runs;
};

TEST(RunDraws, EndAsInACampaign) {
  Campaign campaign{options_of_draws(), {}, {ahead()}};
  for (std::size_t i = 0; i < 9; ++i) campaign.scenarios.push_back(corridor(i));
  OutcomeSink sink;
  const auto progress = make_silent_progress();
  run_campaign(campaign, sink, {1, *progress, nullptr});
  const std::vector<DrawnRun> runs = runs_of(draw_corridor, 9, 2);
  ASSERT_EQ(runs.size(), 9U);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].scenario_hash, campaign.scenarios[i].hash());
    const RunRecord& run = sink.runs.at(runs[i].scenario_hash);
    EXPECT_EQ(to_string(runs[i].outcome), run.outcome);
    EXPECT_EQ(runs[i].trajectory_hash, run.trajectory_hash);
    EXPECT_EQ(runs[i].outcome, i % 3 == 0 ? Outcome::Collision : Outcome::Success);
  }
}

TEST(RunDraws, ArriveInOrderUntilTheReceiverHasEnoughForAnyNumberOfWorkers) {
  const auto hashes = [](int workers) {
    std::vector<std::string> all;
    for (const DrawnRun& run : runs_of(draw_corridor, 40, workers, 11))
      all.push_back(run.scenario_hash + run.trajectory_hash);
    return all;
  };
  const std::vector<std::string> one = hashes(1);
  EXPECT_EQ(one.size(), 11U);
  EXPECT_EQ(hashes(4), one);
}

TEST(RunDraws, UseTheOptionsOfADraw) {
  const auto draw = [](std::size_t index) -> std::optional<RunDraw> {
    CampaignOptions options = options_of_draws();
    options.odometry = {};
    options.robot.delay_tau = index == 0 ? 0 : 8;  // s: 1.3 m of 1.8 m in 5 s
    return RunDraw{corridor(1), options};
  };
  const std::vector<DrawnRun> runs = runs_of(draw, 2, 1);
  EXPECT_EQ(runs.at(0).outcome, Outcome::Success);
  EXPECT_EQ(runs.at(1).outcome, Outcome::Timeout);
}

TEST(RunDraws, AMethodThatCrashesFailsInItsRunOnly) {
  const auto draw = [](std::size_t index) -> std::optional<RunDraw> {
    return RunDraw{corridor(1 + 3 * index, index == 1 ? 2.1 : 2)};
  };
  const std::vector<DrawnRun> runs = runs_of(draw, 3, 1);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].outcome, Outcome::Success);
  EXPECT_EQ(runs[1].outcome, Outcome::MethodCrash);
  EXPECT_EQ(runs[2].outcome, Outcome::Success);
}

TEST(RunDraws, WithoutASolvableScenarioAreNotExecuted) {
  const auto draw = [](std::size_t) -> std::optional<RunDraw> { return std::nullopt; };
  const std::vector<DrawnRun> runs = runs_of(draw, 1, 1);
  EXPECT_EQ(runs.at(0).outcome, Outcome::UnsolvableScenario);
}

TEST(RunDraws, InWhichNobodyCanArriveInTimeAreRefusedByName) {
  const auto draw = [](std::size_t) -> std::optional<RunDraw> {
    CampaignOptions options = options_of_draws();
    options.robot.max_v = 0.3;
    return RunDraw{corridor(1), options};
  };
  EXPECT_TRUE(
      throws_error(ErrorKind::Usage, "[simulation] max_time",
                   {"scenario corridor_1: nobody can arrive within 5 s: the shortest path "
                    "takes at least 6.2 s at 0.3 m/s",  // 1.8 m up to the tolerance, from standing
                    "auto"},
                   [&] { runs_of(draw, 1, 1); }));
}

TEST(RunDraws, HaveTheTimeLimitOfTheirScenario) {
  CampaignOptions options = options_of_draws();
  options.simulation.max_time.reset();
  options.robot.max_v = 0.02;  // 2 m in 100 s: the limit is 400 s
  options.simulation.stuck_time = 20;
  options.odometry = {};
  const auto draw = [&](std::size_t) -> std::optional<RunDraw> {
    return RunDraw{corridor(1), options};
  };
  Campaign campaign{options, {corridor(1)}, {ahead()}};
  OutcomeSink sink;
  run_campaign(campaign, sink, {1, *make_silent_progress(), nullptr});
  const std::vector<DrawnRun> runs = runs_of(draw, 1, 1);
  EXPECT_EQ(runs.at(0).outcome, Outcome::Success);
  EXPECT_EQ(runs.at(0).trajectory_hash, sink.runs.at(runs.at(0).scenario_hash).trajectory_hash);
}

TEST(RunDraws, EndWithTheErrorOfADraw) {
  const auto draw = [](std::size_t) -> std::optional<RunDraw> {
    throw std::runtime_error("the map is gone");
  };
  EXPECT_TRUE(throws_error(ErrorKind::Job, "a run of ahead", {"the map is gone"},
                           [&] { runs_of(draw, 1, 1); }));
}

TEST(RunDraws, AfterOneThatAnInterruptKillsAreNotPassedOn) {
  // Long runs, which are failures, would be left out if those after them took their place.
  const std::vector<DrawnRun> all = runs_of(draw_corridor, 40, 1);
  for (const int workers : {2, 3}) {
    const SharedCount drawn;
    std::vector<DrawnRun> received;
    const auto draw = [&](std::size_t index) {
      if (index == 5) pause();
      ++*drawn;
      return draw_corridor(index);
    };
    EXPECT_FALSE(run_draws(ahead(), options_of_draws(), draw, 1000,
                           {workers, [&] { return *drawn >= 30 && received.size() >= 5; }},
                           [&](const DrawnRun& run) {
                             received.push_back(run);
                             return true;
                           }));
    ASSERT_EQ(received.size(), 5U) << workers;
    for (std::size_t i = 0; i < received.size(); ++i)
      EXPECT_EQ(received[i].trajectory_hash, all[i].trajectory_hash) << i;
  }
}

TEST(RunDraws, AreInterrupted) {
  std::size_t received = 0;
  const auto receive = [&](const DrawnRun&) { return ++received > 0; };
  EXPECT_FALSE(run_draws(ahead(), options_of_draws(), draw_corridor, 1000,
                         {1, [&] { return received >= 2; }}, receive));
  EXPECT_LT(received, 1000U);
}

}  // namespace
}  // namespace slalom
