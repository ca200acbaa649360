#include "recorded_runs.h"

#include <slalom/io/result_file.h>

#include <mrpt/obs/CRawlog.h>

#include <cstring>
#include <error_text.h>

namespace slalom {
namespace {

using testing::MadeRun;
using testing::make_run;

class RunRecorder : public testing::RecordedRunTest {};

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

void expect_same_cycle(const RecordedCycle& read, const testing::SeenCycle& seen) {
  const Observation& a = read.observation;
  const Observation& b = seen.observation;
  EXPECT_TRUE(same_bits(a.time, b.time));
  EXPECT_TRUE(same_bits(a.odometry.x, b.odometry.x));
  EXPECT_TRUE(same_bits(a.odometry.y, b.odometry.y));
  EXPECT_TRUE(same_bits(a.odometry.phi, b.odometry.phi));
  EXPECT_TRUE(same_bits(a.v, b.v) && same_bits(a.w, b.w) && same_bits(a.vy, b.vy));
  EXPECT_TRUE(same_bits(a.goal_in_robot.x, b.goal_in_robot.x));
  EXPECT_TRUE(same_bits(a.goal_in_robot.y, b.goal_in_robot.y));
  EXPECT_TRUE(same_bits(read.command.v, seen.command.v) &&
              same_bits(read.command.w, seen.command.w) &&
              same_bits(read.command.vy, seen.command.vy));
  ASSERT_EQ(read.scan->getScanSize(), seen.ranges.size());
  for (std::size_t i = 0; i < seen.ranges.size(); ++i)
    ASSERT_EQ(read.scan->getScanRange(i), seen.ranges[i]);
  EXPECT_NEAR(mrpt::Clock::toDouble(read.stamp) - mrpt::Clock::toDouble(read.scan->timestamp),
              seen.scan_age, 1e-6);
}

void expect_same_run(const RecordedRun& read, const MadeRun& made) {
  EXPECT_EQ(read.trajectory.hash(), made.result.trajectory.hash());
  EXPECT_EQ(read.trajectory.samples.size(), made.result.trajectory.samples.size());
  EXPECT_EQ(read.outcome, made.result.outcome);
  EXPECT_EQ(read.detail, made.result.detail);
  ASSERT_EQ(read.cycles.size(), made.cycles.size());
  for (std::size_t i = 0; i < made.cycles.size(); ++i)
    expect_same_cycle(read.cycles[i], made.cycles[i]);
}

TEST_F(RunRecorder, ARunReadBackIsTheRunBitByBit) {
  const RunSetup setup = testing::uneven_setup();
  testing::RandomMethod method(setup.robot);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const MadeRun made = make_run(path("run.rawlog"), method, setup, seed);
    ASSERT_GT(made.cycles.size(), 5U);
    expect_same_run(read_run(path("run.rawlog")), made);
  }
}

TEST_F(RunRecorder, ARunOfAHolonomicRobotToo) {
  RunSetup setup = testing::uneven_setup();
  setup.robot.kinematics = "holonomic";
  setup.robot.forward_only = false;
  testing::FunctionMethod method([](const Observation& o) {
    return Command{0.3 * std::sin(o.time), -0.5, -0.4 * std::cos(3 * o.time)};
  });
  const MadeRun made = make_run(path("run.rawlog"), method, setup);
  expect_same_run(read_run(path("run.rawlog")), made);
}

TEST_F(RunRecorder, TheManifestHasAllThatTheRunCameFrom) {
  auto method = testing::constant_method(0.5, 0);
  const MadeRun made = make_run(path("run.rawlog"), method, {}, 0xfedcba9876543210U);
  const RecordedRun read = read_run(path("run.rawlog"));
  EXPECT_EQ(read.manifest.campaign_ini,
            IniFile::from_text(read.manifest.campaign_ini).canonical_text());
  EXPECT_EQ(*IniFile::from_text(read.manifest.campaign_ini).get("method.m", "x"), "1");
  EXPECT_EQ(scenario_from_yaml(read.manifest.scenario_yaml, "yaml").hash(),
            testing::some_discs().hash());
  EXPECT_EQ(read.manifest.scenario_hash, testing::some_discs().hash());
  EXPECT_EQ(read.manifest.scenario_name, "some discs");
  EXPECT_EQ(read.manifest.method, "m");
  EXPECT_EQ(read.manifest.repetition, 2);
  EXPECT_EQ(read.manifest.seed, 0xfedcba9876543210U);
  EXPECT_EQ(read.manifest.more.count("version.mrpt"), 1U);
  ASSERT_TRUE(read.task.has_value());
  EXPECT_EQ(read.task->seed, made.task.seed);
  EXPECT_TRUE(same_bits(read.task->start.phi, made.task.start.phi));
  EXPECT_EQ(read.task->goal_tolerance, made.task.goal_tolerance);
  EXPECT_EQ(read.task->control_period, made.task.control_period);
}

TEST_F(RunRecorder, TheSameRunGivesTheSameBytesWhateverRanBefore) {
  auto method = testing::constant_method(0.4, 0.1);
  make_run(path("a.rawlog"), method, {});
  make_run(path("other.rawlog"), method, testing::uneven_setup());
  make_run(path("b.rawlog"), method, {});
  EXPECT_EQ(read_file(path("a.rawlog")), read_file(path("b.rawlog")));
  EXPECT_NE(read_file(path("a.rawlog")), read_file(path("other.rawlog")));
}

TEST_F(RunRecorder, MrptReadsEveryObjectWithItsTime) {
  auto method = testing::constant_method(0.4, 0);
  const MadeRun made = make_run(path("run.rawlog"), method, {});
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile(path("run.rawlog")));
  // Four objects a cycle and the last true pose; MRPT keeps comments apart.
  ASSERT_EQ(log.size(), 4 * made.cycles.size() + 1);
  EXPECT_NE(log.getCommentText().find("outcome = "), std::string::npos);
  const double begin = mrpt::Clock::toDouble(log.getAsObservation(0)->timestamp);
  for (std::size_t i = 0; i < 4 * made.cycles.size(); ++i)
    EXPECT_NEAR(mrpt::Clock::toDouble(log.getAsObservation(i)->timestamp) - begin,
                made.cycles[i / 4].observation.time, 1e-6);
  EXPECT_NEAR(mrpt::Clock::toDouble(log.getAsObservation(log.size() - 1)->timestamp) - begin,
              made.result.trajectory.samples.back().t, 1e-6);
}

TEST_F(RunRecorder, ARunThatCannotBeginHasAResultAndNoCycles) {
  const Scenario blocked = testing::some_discs().with_task({4, 5, 0}, {9, 5});  // in a disc
  const World world(blocked, 0.05);
  auto method = testing::constant_method(0.4, 0);
  const auto recorder = make_rawlog_recorder(
      path("run.rawlog"), make_run_manifest(IniFile::from_text(""), blocked, "m", 0, 1));
  const SimulationResult result = simulate(world, {}, 1, method, recorder.get());
  ASSERT_EQ(result.outcome, Outcome::UnsolvableScenario);
  const RecordedRun read = read_run(path("run.rawlog"));
  EXPECT_EQ(read.outcome, Outcome::UnsolvableScenario);
  EXPECT_TRUE(read.cycles.empty());
  EXPECT_EQ(read.trajectory.hash(), result.trajectory.hash());
}

TEST_F(RunRecorder, AnAnswerThatEndsTheRunKeepsTheCyclesBeforeIt) {
  testing::FunctionMethod method([](const Observation& o) {
    return Command{o.time < 0.95 ? 0.2 : std::nan(""), 0};
  });
  const MadeRun made = make_run(path("run.rawlog"), method, {});
  const RecordedRun read = read_run(path("run.rawlog"));
  EXPECT_EQ(read.outcome, Outcome::MethodInvalidCommand);
  EXPECT_EQ(read.cycles.size(), 10U);
  expect_same_run(read, made);
}

TEST_F(RunRecorder, TextsOfSeveralLinesComeBackAsTheyWere) {
  for (const std::string detail :
       {"two\nlines", " blanks ", "\n", "", "ends\n", "key = value\n  = x"}) {
    const auto recorder = make_rawlog_recorder(
        path("run.rawlog"),
        make_run_manifest(IniFile::from_text(""), testing::some_discs(), "m", 0, 1));
    SimulationResult result;
    result.detail = detail;
    recorder->on_end(result);
    EXPECT_EQ(read_run(path("run.rawlog")).detail, detail);
  }
}

TEST_F(RunRecorder, AFileThatCannotBeWrittenIsTold) {
  auto method = testing::constant_method(0.4, 0);
  const std::string text =
      error_text(Culprit::Job, [&] { make_run(path("no/such/run.rawlog"), method, {}); });
  EXPECT_NE(text.find("no/such/run.rawlog"), std::string::npos) << text;
}

}  // namespace
}  // namespace slalom
