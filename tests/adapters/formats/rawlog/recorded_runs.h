// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../../modules/run/simulation/test_runs.h"

#include <slalom/io/scenario_yaml.h>
#include <slalom/rawlog/run_reader.h>
#include <slalom/rawlog/run_recorder.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace slalom::testing {

/// A temporary folder for each test.
class RecordedRunTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = ::testing::TempDir() + "slalom_rawlog_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

/// Data of one cycle of a run, as passed to the recorder.
struct ObservedCycle {
  Observation observation;
  std::vector<float> ranges;
  double scan_age;  ///< s
  Command command;
};

/// Forwards a run to a recorder and keeps its data.
class CapturingObserver : public RunObserver {
 public:
  explicit CapturingObserver(RunObserver& recorder) : recorder_(recorder) {}

  void on_start(const NavigationTask& task) override {
    task_ = task;
    recorder_.on_start(task);
  }
  void on_cycle(const Observation& observation, const Command& command,
                const mrpt::math::TPose2D& pose) override {
    ObservedCycle cycle{observation, {}, 0, command};
    for (std::size_t i = 0; i < observation.scan->getScanSize(); ++i)
      cycle.ranges.push_back(observation.scan->getScanRange(i));
    cycle.scan_age = mrpt::Clock::toDouble(mrpt::Clock::now()) -
                     mrpt::Clock::toDouble(observation.scan->timestamp);
    cycles_.push_back(cycle);
    recorder_.on_cycle(observation, command, pose);
  }
  void on_end(const SimulationResult& result) override { recorder_.on_end(result); }

  NavigationTask task_;
  std::vector<ObservedCycle> cycles_;

 private:
  RunObserver& recorder_;
};

inline Scenario some_discs() {
  Primitives obstacles;
  obstacles.discs = {{{4, 5.2}, 0.6}, {{7, 3.1}, 0.8}, {{2.5, 8}, 0.4}};
  return Scenario::continuous("some discs", {0, 0, 10, 10}, obstacles, {1, 5, 0.1}, {9, 5});
}

/// A run of `method` in a scenario, recorded at `path`.
struct SimulatedRun {
  SimulationResult result;
  NavigationTask task;
  std::vector<ObservedCycle> cycles;
};

inline SimulatedRun simulate_run(const std::string& path, Method& method, const RunSetup& setup,
                                 std::uint64_t seed = 7, const Scenario& scenario = some_discs()) {
  const World world(scenario, setup.simulation.resolution);
  const IniFile ini = IniFile::from_text("[campaign]\nseed = 3\nmethods = m\n[method.m]\nx = 1\n");
  const auto recorder = make_rawlog_recorder(
      path, make_run_manifest(ini.canonical_text(), world.scenario(), "m", 2, seed));
  CapturingObserver observer(*recorder);
  SimulatedRun run;
  run.result = simulate(world, setup, seed, method, &observer);
  run.task = observer.task_;
  run.cycles = observer.cycles_;
  return run;
}

/// A setup with noise, drift and delays, so that numbers are not round.
inline RunSetup noisy_setup() {
  RunSetup setup;
  setup.robot.delay = 0.03;
  setup.robot.delay_tau = 0.2;
  setup.sensor.noise_sigma = 0.02;
  setup.sensor.dropout_ratio = 0.05;
  setup.sensor.latency = 0.07;
  setup.odometry = {0.05, 0.1};
  setup.simulation.max_time = 12;
  return setup;
}

}  // namespace slalom::testing
