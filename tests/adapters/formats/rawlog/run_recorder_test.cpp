// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_runs.h"

#include <slalom/core/read_file.h>
#include <slalom/rawlog/run_scene.h>

#include <mrpt/obs/CRawlog.h>

#include <cmath>
#include <error_text.h>

namespace slalom {
namespace {

using testing::simulate_run;
using testing::SimulatedRun;

class RunRecorder : public testing::RecordedRunTest {};

bool same_bits(double a, double b) {
  return a == b ? std::signbit(a) == std::signbit(b) : std::isnan(a) && std::isnan(b);
}

void expect_same_cycle(const RecordedCycle& read, const testing::ObservedCycle& observed) {
  const Observation& a = read.observation;
  const Observation& b = observed.observation;
  EXPECT_TRUE(same_bits(a.time, b.time));
  EXPECT_TRUE(same_bits(a.odometry.x, b.odometry.x));
  EXPECT_TRUE(same_bits(a.odometry.y, b.odometry.y));
  EXPECT_TRUE(same_bits(a.odometry.phi, b.odometry.phi));
  EXPECT_TRUE(same_bits(a.v, b.v) && same_bits(a.w, b.w) && same_bits(a.vy, b.vy));
  EXPECT_TRUE(same_bits(a.goal_in_robot.x, b.goal_in_robot.x));
  EXPECT_TRUE(same_bits(a.goal_in_robot.y, b.goal_in_robot.y));
  EXPECT_TRUE(same_bits(read.command.v, observed.command.v) &&
              same_bits(read.command.w, observed.command.w) &&
              same_bits(read.command.vy, observed.command.vy));
  ASSERT_EQ(read.scan->getScanSize(), observed.ranges.size());
  for (std::size_t i = 0; i < observed.ranges.size(); ++i)
    ASSERT_EQ(read.scan->getScanRange(i), observed.ranges[i]);
  EXPECT_NEAR(mrpt::Clock::toDouble(read.stamp) - mrpt::Clock::toDouble(read.scan->timestamp),
              observed.scan_age, 1e-6);
}

void expect_same_run(const RecordedRun& read, const SimulatedRun& simulated) {
  EXPECT_EQ(read.trajectory.hash(), simulated.result.trajectory.hash());
  EXPECT_EQ(read.trajectory.samples.size(), simulated.result.trajectory.samples.size());
  EXPECT_EQ(read.outcome, simulated.result.outcome);
  EXPECT_EQ(read.detail, simulated.result.detail);
  ASSERT_EQ(read.cycles.size(), simulated.cycles.size());
  for (std::size_t i = 0; i < simulated.cycles.size(); ++i)
    expect_same_cycle(read.cycles[i], simulated.cycles[i]);
}

TEST_F(RunRecorder, HasMoversInItsScansAndInItsScenario) {
  // The robot stands at (1, 5) and looks along x at a disc of 0.5 m, which comes at 1 m/s.
  const Movers movers = {{"walker", 0.5, {{0, {6, 5}}, {2, {4, 5}}}, MoverEnd::Stop}};
  const Scenario scenario = Scenario::continuous("walk", {0, 0, 10, 10}, {}, {1, 5, 0}, {9, 5});
  RunSetup setup;
  setup.simulation.max_time = 2;
  auto method = testing::constant_method(0, 0);
  simulate_run(path("run.rawlog"), method, setup, 7, scenario.with_movers(movers));
  const RecordedRun read = read_run(path("run.rawlog"));
  ASSERT_GT(read.cycles.size(), 10U);
  for (const RecordedCycle& cycle : read.cycles) {
    const std::size_t ahead = cycle.scan->getScanSize() / 2;
    ASSERT_NEAR(cycle.scan->getScanAngle(ahead), 0, 1e-6);
    EXPECT_NEAR(static_cast<double>(cycle.scan->getScanRange(ahead)),
                6 - cycle.observation.time - 0.5 - 1, 1e-5);
  }
  EXPECT_EQ(scenario_from_yaml(read.manifest.scenario_yaml, "manifest").movers(), movers);
  const SceneOptions picture = scene_at(read, 10, setup.robot, 100);
  EXPECT_EQ(picture.time, read.trajectory.samples[10].t);
  EXPECT_NEAR(movers[0].position(*picture.time).x, 6 - read.cycles[10].observation.time, 1e-9);
}

TEST_F(RunRecorder, ReadsBackABitIdenticalRun) {
  const RunSetup setup = testing::noisy_setup();
  testing::RandomMethod method(setup.robot);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const SimulatedRun simulated = simulate_run(path("run.rawlog"), method, setup, seed);
    ASSERT_GT(simulated.cycles.size(), 5U);
    expect_same_run(read_run(path("run.rawlog")), simulated);
  }
}

TEST_F(RunRecorder, ReadsBackTheScansOfEachLaser) {
  RunSetup setup = testing::noisy_setup();
  setup.sensor.lasers.resize(2);
  setup.sensor.lasers[0].name = "left";
  setup.sensor.lasers[0].y = 0.2;
  setup.sensor.lasers[0].rays = 31;
  setup.sensor.lasers[1].name = "rear";
  setup.sensor.lasers[1].yaw = 3;
  setup.sensor.lasers[1].upside_down = true;
  testing::RandomMethod method(setup.robot);
  const SimulatedRun simulated = simulate_run(path("run.rawlog"), method, setup, 4);
  const RecordedRun read = read_run(path("run.rawlog"));
  ASSERT_GT(read.cycles.size(), 5U);
  expect_same_run(read, simulated);
  for (const RecordedCycle& cycle : read.cycles) {
    ASSERT_EQ(cycle.observation.lasers.size(), 2U);
    EXPECT_EQ(cycle.observation.lasers[0]->sensorLabel, "left");
    EXPECT_EQ(cycle.observation.lasers[0]->getScanSize(), 31U);
    EXPECT_EQ(cycle.observation.lasers[1]->sensorLabel, "rear");
    EXPECT_NEAR(cycle.observation.lasers[1]->sensorPose.yaw(), 3, 1e-9);
    EXPECT_EQ(cycle.observation.scan->sensorLabel, "range_finder");
  }
}

TEST_F(RunRecorder, ReadsBackTheHeadingOfTheGoal) {
  RunSetup setup;
  setup.simulation.goal_heading_tolerance = 1.0 / 7;
  auto method = testing::constant_method(0.5, 0);
  simulate_run(path("run.rawlog"), method, setup, 7, testing::some_discs().with_goal_heading(-0.1));
  const RecordedRun read = read_run(path("run.rawlog"));
  EXPECT_EQ(read.task->goal_heading, -0.1);
  EXPECT_EQ(read.task->goal_heading_tolerance, 1.0 / 7);
  EXPECT_EQ(scenario_from_yaml(read.manifest.scenario_yaml, "yaml").goal_heading(), -0.1);
}

TEST_F(RunRecorder, ReadsBackARunOfAHolonomicRobot) {
  RunSetup setup = testing::noisy_setup();
  setup.robot.kinematics = Kinematics::Holonomic;
  setup.robot.forward_only = false;
  testing::FunctionMethod method([](const Observation& o) {
    return Command{0.3 * std::sin(o.time), -0.5, -0.4 * std::cos(3 * o.time)};
  });
  const SimulatedRun simulated = simulate_run(path("run.rawlog"), method, setup);
  expect_same_run(read_run(path("run.rawlog")), simulated);
}

TEST_F(RunRecorder, TheManifestDescribesTheRun) {
  auto method = testing::constant_method(0.5, 0);
  const SimulatedRun simulated = simulate_run(path("run.rawlog"), method, {}, 0xfedcba9876543210U);
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
  EXPECT_EQ(read.task->seed, simulated.task.seed);
  EXPECT_TRUE(same_bits(read.task->start.phi, simulated.task.start.phi));
  EXPECT_EQ(read.task->goal_tolerance, simulated.task.goal_tolerance);
  EXPECT_EQ(read.task->control_period, simulated.task.control_period);
}

TEST_F(RunRecorder, TheSameRunGivesTheSameBytesRegardlessOfPreviousRuns) {
  auto method = testing::constant_method(0.4, 0.1);
  simulate_run(path("a.rawlog"), method, {});
  simulate_run(path("other.rawlog"), method, testing::noisy_setup());
  simulate_run(path("b.rawlog"), method, {});
  EXPECT_EQ(read_file(path("a.rawlog")), read_file(path("b.rawlog")));
  EXPECT_NE(read_file(path("a.rawlog")), read_file(path("other.rawlog")));
}

TEST_F(RunRecorder, MrptReadsAllObjectsWithTheirTimes) {
  auto method = testing::constant_method(0.4, 0);
  const SimulatedRun simulated = simulate_run(path("run.rawlog"), method, {});
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile(path("run.rawlog")));
  // Four objects per cycle and the last ground-truth pose; MRPT stores comments separately.
  ASSERT_EQ(log.size(), 4 * simulated.cycles.size() + 1);
  EXPECT_NE(log.getCommentText().find("outcome = "), std::string::npos);
  const double begin = mrpt::Clock::toDouble(log.getAsObservation(0)->timestamp);
  for (std::size_t i = 0; i < 4 * simulated.cycles.size(); ++i)
    EXPECT_NEAR(mrpt::Clock::toDouble(log.getAsObservation(i)->timestamp) - begin,
                simulated.cycles[i / 4].observation.time, 1e-6);
  EXPECT_NEAR(mrpt::Clock::toDouble(log.getAsObservation(log.size() - 1)->timestamp) - begin,
              simulated.result.trajectory.samples.back().t, 1e-6);
}

TEST_F(RunRecorder, ARunThatCannotStartHasAResultAndNoCycles) {
  const Scenario blocked = testing::some_discs().with_start_goal({4, 5, 0}, {9, 5});  // in a disc
  const World world(blocked, 0.05);
  auto method = testing::constant_method(0.4, 0);
  const auto recorder =
      make_rawlog_recorder(path("run.rawlog"), make_run_manifest("", blocked, "m", 0, 1));
  const SimulationResult result = simulate(world, {}, 1, method, recorder.get());
  ASSERT_EQ(result.outcome, Outcome::UnsolvableScenario);
  const RecordedRun read = read_run(path("run.rawlog"));
  EXPECT_EQ(read.outcome, Outcome::UnsolvableScenario);
  EXPECT_TRUE(read.cycles.empty());
  EXPECT_EQ(read.trajectory.hash(), result.trajectory.hash());
}

TEST_F(RunRecorder, AnInvalidCommandKeepsThePreviousCycles) {
  testing::FunctionMethod method([](const Observation& o) {
    return Command{o.time < 0.95 ? 0.2 : std::nan(""), 0};
  });
  const SimulatedRun simulated = simulate_run(path("run.rawlog"), method, {});
  const RecordedRun read = read_run(path("run.rawlog"));
  EXPECT_EQ(read.outcome, Outcome::MethodInvalidCommand);
  EXPECT_EQ(read.cycles.size(), 10U);
  expect_same_run(read, simulated);
}

TEST_F(RunRecorder, PreservesMultilineTexts) {
  for (const std::string detail :
       {"two\nlines", " blanks ", "\n", "", "ends\n", "key = value\n  = x"}) {
    const auto recorder = make_rawlog_recorder(
        path("run.rawlog"), make_run_manifest("", testing::some_discs(), "m", 0, 1));
    SimulationResult result;
    result.detail = detail;
    recorder->on_end(result);
    EXPECT_EQ(read_run(path("run.rawlog")).detail, detail);
  }
}

TEST_F(RunRecorder, ReportsWriteErrors) {
  auto method = testing::constant_method(0.4, 0);
  EXPECT_TRUE(throws_error(ErrorKind::Job, "", {"no/such/run.rawlog"},
                           [&] { simulate_run(path("no/such/run.rawlog"), method, {}); }));
}

}  // namespace
}  // namespace slalom
