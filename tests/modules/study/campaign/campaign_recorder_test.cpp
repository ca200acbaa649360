// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "io_sample.h"
#include "manual_time.h"

#include <slalom/campaign/campaign_recorder.h>
#include <slalom/campaign/open_results.h>
#include <slalom/io/campaign_identity.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace slalom {
namespace {

/// Moves straight ahead; in the scenario with the goal at 2 m only after `clock` shows 1 s.
class PatientMethod : public Method {
 public:
  explicit PatientMethod(WallClock clock) : clock_(std::move(clock)) {}
  void reset(const NavigationTask& task) override { waits_ = task.goal.x == 2; }
  Command step(const Observation&) override {
    while (waits_ && clock_() < 1) usleep(500);
    return {1, 0};
  }

 private:
  WallClock clock_;
  bool waits_ = false;
};

Scenario room(double goal_x) {
  return Scenario::continuous("to_" + std::to_string(goal_x), {0, 0, 5, 4}, Primitives(), {1, 2, 0},
                              {goal_x, 2});
}

class CampaignRecorderTest : public testing::Test {
 protected:
  static CampaignOptions options() {
    CampaignOptions options;
    options.metrics = {"success", "time_to_goal"};
    options.descriptors = {"density"};
    return options;
  }

  CampaignRecorder recorder(const RecorderOptions& recording = {}) const {
    const MethodFactory make = [clock = time_.clock()](const RobotModel&, const SensorModel&) {
      return std::make_unique<PatientMethod>(clock);
    };
    return CampaignRecorder(
        {options(), {}, {{"patient", make, ""}}},
        open_results(path_, {{kEffectiveKey, ""}}, {}, options(), ExistingResults::Continue),
        recording);
  }

  std::size_t stored_runs() const {
    SQLite::Database database(path_);
    return static_cast<std::size_t>(database.execAndGet("SELECT count(*) FROM runs").getInt());
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "runs.results";
  const std::unique_ptr<Progress> progress_ = make_silent_progress();
  const Execution execution_{2, *progress_, nullptr};
  ManualTime time_;  ///< shared with the workers
};

TEST_F(CampaignRecorderTest, ReportsARunThatIsShorterThanItsBoundWithItsReproduction) {
  const Scenario scenario = room(3);  // 2 m from its start
  {
    References forged;
    forged.shortest = ShortestPath{};
    forged.shortest->path = {{1, 2}, {3, 2}};
    forged.shortest->length = forged.shortest->exact_length = 2.125;
    forged.shortest->certificate = {2.125, 2.125};
    ResultFile file = ResultFile::create(path_, {{kEffectiveKey, ""}}, options().descriptor_infos(),
                                         options().metric_infos());
    file.add_scenario({scenario.hash(), scenario.name(), {{"density", {1, Value::of(0)}}}},
                      scenario, forged);
    ASSERT_TRUE(file.commit());
  }
  CampaignRecorder campaign = recorder();
  EXPECT_TRUE(campaign.run({scenario, room(3.5)}, execution_));
  EXPECT_TRUE(mentions(campaign.problem(),
                       {"1 runs ended as infrastructure_error",
                        scenario.hash().substr(0, 8) + "/patient/0: ", "is shorter than possible",
                        "shortest path 2.125 m", "--ids " + scenario.hash(), "--seed 1 ",
                        "--set campaign.methods=patient", "--set campaign.repetitions=1"}));
  const auto stored = campaign.file().read_run(scenario.hash(), "patient", 0);
  ASSERT_TRUE(stored.has_value());
  EXPECT_EQ(stored->metrics.at("time_to_goal").value.reason(), "outcome: infrastructure_error");
}

TEST_F(CampaignRecorderTest, StoresFinishedRunsWhileTheFirstOneOfThePlanTakesLong) {
  double now = 0;
  const WallClock clock = [&now] { return ++now; };  // a second passes between two readings
  // The first run ends when the second is stored.
  const Execution polling{2, *progress_, [this] {
                            if (stored_runs() == 1) time_.advance(1);
                            return false;
                          }};
  EXPECT_TRUE(recorder({clock, nullptr}).run({room(2), room(3)}, polling));
  EXPECT_EQ(stored_runs(), 2U);
}

TEST_F(CampaignRecorderTest, AReaderOnlyDelaysStoring) {
  time_.advance(1);
  std::vector<std::string> notices;
  std::unique_ptr<SQLite::Database> reader;
  CampaignRecorder slow = recorder({time_.clock(), [&](const std::string& notice) {
                                      notices.push_back(notice);
                                      reader.reset();
                                    }});
  reader = std::make_unique<SQLite::Database>(path_);
  reader->exec("BEGIN; SELECT count(*) FROM runs");
  EXPECT_TRUE(slow.run({room(2), room(3)}, execution_));
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_NE(notices[0].find("another program is reading it"), std::string::npos);
  EXPECT_EQ(stored_runs(), 2U);
}

TEST_F(CampaignRecorderTest, RunsOnlyWhatIsMissing) {
  time_.advance(1);
  EXPECT_TRUE(recorder().run({room(2)}, execution_));
  CampaignRecorder continued = recorder();
  EXPECT_EQ(continued.known_runs(), 1U);
  std::size_t polls = 0;
  const Execution counting{1, *progress_, [&] {
                             ++polls;
                             return false;
                           }};
  EXPECT_TRUE(continued.run({room(2), room(3)}, counting));
  EXPECT_EQ(stored_runs(), 2U);
  EXPECT_GT(polls, 0U);
  polls = 0;
  EXPECT_TRUE(recorder().run({room(2), room(3)}, counting));
  EXPECT_EQ(polls, 0U);  // no work item at all
}

/// Runs two scenarios; `change` is called when the first one is stored, and the second ends then.
/// Returns the text of the error.
class CampaignWithAChangedFile : public CampaignRecorderTest {
 protected:
  std::string error_after(const std::function<void()>& change) {
    double now = 0;
    const WallClock clock = [&now] { return ++now; };
    CampaignRecorder campaign = recorder({clock, nullptr});
    bool changed = false;
    const Execution polling{2, *progress_, [&] {
                              if (changed || stored_runs() < 1) return false;
                              change();
                              changed = true;
                              time_.advance(1);
                              return false;
                            }};
    return error_text(ErrorKind::Job, [&] { campaign.run({room(2), room(3)}, polling); });
  }
};

TEST_F(CampaignWithAChangedFile, RemovedIsAnErrorAndWhatWasStoredIsKept) {
  const std::string error = error_after([&] { std::filesystem::remove(path_); });
  EXPECT_TRUE(mentions(error, {path_, "was removed", "1 run is kept in " + path_ + ".rescued"}));
  std::filesystem::rename(path_ + ".rescued", path_);
  EXPECT_EQ(stored_runs(), 1U);
  EXPECT_EQ(recorder().known_runs(), 1U);  // it can be continued
}

TEST_F(CampaignWithAChangedFile, RenamedIsAnErrorAndWhatWasStoredIsKept) {
  const std::string error = error_after([&] { std::filesystem::rename(path_, path_ + ".moved"); });
  EXPECT_TRUE(mentions(error, {"was removed", "1 run is kept in " + path_ + ".rescued"}));
}

TEST_F(CampaignWithAChangedFile, ReplacedIsAnErrorAndWhatWasStoredIsKept) {
  const std::string error = error_after([&] {
    std::filesystem::copy(path_, path_ + ".copy");
    std::filesystem::rename(path_ + ".copy", path_);
  });
  EXPECT_TRUE(mentions(error, {"was replaced", "1 run is kept in " + path_ + ".rescued"}));
}

TEST_F(CampaignWithAChangedFile, TruncatedIsAnErrorThatSaysWhetherRunsAreKept) {
  const std::string error = error_after([&] { std::filesystem::resize_file(path_, 0); });
  EXPECT_TRUE(mentions(error, {"was truncated"}));
  EXPECT_EQ(error.find(" kept in ") != std::string::npos,
            std::filesystem::exists(path_ + ".rescued"));
}

TEST_F(CampaignRecorderTest, KeepsWhatAReaderPreventsFromBeingStoredWhenItIsInterrupted) {
  time_.advance(1);
  double now = 0;
  const WallClock clock = [&now] { return now += 30; };
  CampaignRecorder campaign = recorder({clock, nullptr});
  SQLite::Database reader(path_);
  reader.exec("BEGIN; SELECT count(*) FROM runs");
  // The run has ended long before.
  const Execution late{1, *progress_, [&] { return now > 300; }};
  const std::string error = error_text(ErrorKind::Job, [&] { campaign.run({room(3)}, late); });
  EXPECT_TRUE(mentions(error, {"is being read by another program", path_ + ".rescued"}));
}

}  // namespace
}  // namespace slalom
