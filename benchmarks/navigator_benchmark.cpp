// SPDX-License-Identifier: BSD-3-Clause
// Control cycles per second of MRPT's CReactiveNavigationSystem with its default configuration, on
// one core. `simulated` is simulate() with the navigator as its method (sensing, motion, collision
// checking, recording). `alone` is the navigator only: the same cycles, with previously recorded
// poses and obstacle points passed through a minimal interface. The difference is the cost of the
// simulator and the adapter. Counter `cycles` is control cycles per second.
#include <slalom/core/random.h>
#include <slalom/mrpt_nav/navigator_method.h>
#include <slalom/simulation/run_observer.h>
#include <slalom/simulation/simulate.h>

#include <benchmark/benchmark.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/nav/reactive/CReactiveNavigationSystem.h>
#include <mrpt/nav/registerAllClasses.h>

#include <cmath>
#include <filesystem>
#include <memory>

namespace slalom {
namespace {

using mrpt::math::TPose2D;

const char* const kConfig = "/usr/share/mrpt/config_files/navigation-ptgs/reactive2d_config.ini";
constexpr int kWorlds = 8;

Scenario scenario_of_discs(std::uint64_t seed) {
  RandomEngine random(seed);
  Primitives obstacles;
  for (int i = 0; i < 8; ++i)
    obstacles.discs.push_back({{uniform_real(random, 2, 8), uniform_real(random, 0.5, 9.5)},
                               uniform_real(random, 0.2, 0.5)});
  return Scenario::continuous("world", {0, 0, 10, 10}, obstacles, {1, 5, 0}, {9, 5});
}

const std::vector<std::unique_ptr<World>>& all_worlds() {
  static const std::vector<std::unique_ptr<World>> worlds = [] {
    std::vector<std::unique_ptr<World>> made;
    for (int i = 0; i < kWorlds; ++i) {
      made.push_back(std::make_unique<World>(scenario_of_discs(i), 0.05));
      made.back()->distance_field();
      made.back()->ray_caster();
    }
    return made;
  }();
  return worlds;
}

std::unique_ptr<Method> navigator_method() {
  const IniFile ini = IniFile::from_text(
      "[method.a]\nadapter = mrpt_navigator\nrobot = config\nconfig = " + std::string(kConfig));
  return read_navigator_method(ini, "method.a")({}, {});
}

void count(benchmark::State& state, std::size_t cycles) {
  state.counters["cycles"] =
      benchmark::Counter(static_cast<double>(cycles), benchmark::Counter::kIsRate);
}

void simulated(benchmark::State& state) {
  const auto method = navigator_method();
  const RunSetup setup;
  std::size_t cycles = 0;
  simulate(*all_worlds()[0], setup, 1, *method);
  for (auto _ : state)
    for (const auto& world : all_worlds())
      cycles += simulate(*world, setup, 1, *method).cycle_seconds.size();
  count(state, cycles);
}

struct Cycle {
  TPose2D pose;
  mrpt::math::TTwist2D velocity;
  mrpt::maps::CSimplePointsMap obstacles;
};

/// Records the navigator's inputs from the robot interface.
class CycleRecorder : public RunObserver {
 public:
  std::vector<Cycle> cycles;

  void on_start(const NavigationTask&) override {}
  void on_end(const SimulationResult&) override {}
  void on_cycle(const Observation& observation, const Command&, const TPose2D&) override {
    Cycle cycle;
    cycle.pose = observation.odometry;
    cycle.velocity = {observation.v * std::cos(observation.odometry.phi),
                      observation.v * std::sin(observation.odometry.phi), observation.w};
    const auto rays = static_cast<double>(observation.scan->getScanSize());
    for (std::size_t i = 0; i < observation.scan->getScanSize(); ++i) {
      if (!observation.scan->getScanRangeValidity(i)) continue;
      const float range = observation.scan->getScanRange(i);
      const double angle = observation.scan->aperture * (static_cast<double>(i) / (rays - 1) - 0.5);
      cycle.obstacles.insertPoint(range * static_cast<float>(std::cos(angle)),
                                  range * static_cast<float>(std::sin(angle)), 0.1F);
    }
    cycles.push_back(cycle);
  }
};

/// Provides the recorded cycles one after another.
class RecordedRobot : public mrpt::nav::CRobot2NavInterface {
 public:
  const Cycle* cycle = nullptr;
  double time = 0;

  bool getCurrentPoseAndSpeeds(TPose2D& pose, mrpt::math::TTwist2D& velocity,
                               mrpt::system::TTimeStamp& timestamp, TPose2D& odometry,
                               std::string&) override {
    pose = odometry = cycle->pose;
    velocity = cycle->velocity;
    timestamp = mrpt::Clock::now();
    return true;
  }
  bool senseObstacles(mrpt::maps::CSimplePointsMap& obstacles,
                      mrpt::system::TTimeStamp& timestamp) override {
    obstacles = cycle->obstacles;
    timestamp = mrpt::Clock::now();
    return true;
  }
  bool changeSpeeds(const mrpt::kinematics::CVehicleVelCmd&) override { return true; }
  bool changeSpeedsNOP() override { return true; }
  bool stop(bool) override { return true; }
  mrpt::kinematics::CVehicleVelCmd::Ptr getStopCmd() override {
    return std::make_shared<mrpt::kinematics::CVehicleVelCmd_DiffDriven>();
  }
  mrpt::kinematics::CVehicleVelCmd::Ptr getEmergencyStopCmd() override { return getStopCmd(); }
  double getNavigationTime() override { return time; }
};

/// The cycles of the same runs.
std::vector<std::vector<Cycle>> recorded_runs() {
  const auto method = navigator_method();
  std::vector<std::vector<Cycle>> runs;
  for (const auto& world : all_worlds()) {
    CycleRecorder recorder;
    simulate(*world, RunSetup(), 1, *method, &recorder);
    runs.push_back(std::move(recorder.cycles));
  }
  return runs;
}

/// Advances MRPT's clock and the robot's.
void advance(RecordedRobot& robot, double seconds) {
  robot.time += seconds;
  mrpt::Clock::setSimulatedTime(mrpt::Clock::now() +
                                mrpt::Clock::duration(std::llround(seconds * 1e7)));
}

std::size_t navigate(mrpt::nav::CAbstractNavigator& navigator, RecordedRobot& robot,
                     const std::vector<Cycle>& run) {
  mrpt::nav::CAbstractNavigator::TNavigationParams target;
  target.target.target_coords = {9, 5, 0};
  target.target.targetAllowedDistance = 0.2F;
  navigator.cancel();
  navigator.navigationStep();
  navigator.navigate(&target);
  advance(robot, 2);
  for (const Cycle& cycle : run) {
    robot.cycle = &cycle;
    navigator.navigationStep();
    advance(robot, 0.1);
  }
  return run.size();
}

void alone(benchmark::State& state) {
  const auto runs = recorded_runs();
  mrpt::nav::registerAllClasses_mrpt_nav();
  RecordedRobot robot;
  robot.time = 1;
  mrpt::nav::CReactiveNavigationSystem navigator(robot, false);
  navigator.logging_enable_console_output = false;
  navigator.setMinLoggingLevel(mrpt::system::LVL_ERROR);
  const mrpt::config::CConfigFile config(kConfig);
  navigator.loadConfigFile(config);
  navigator.params_abstract_ptg_navigator.ptg_cache_files_directory =
      std::filesystem::temp_directory_path().string();
  navigator.initialize();
  std::size_t cycles = 0;
  navigate(navigator, robot, runs[0]);
  for (auto _ : state)
    for (const auto& run : runs) cycles += navigate(navigator, robot, run);
  count(state, cycles);
}

BENCHMARK(alone)->Unit(benchmark::kMillisecond);
BENCHMARK(simulated)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace slalom
