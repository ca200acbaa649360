// SPDX-License-Identifier: BSD-3-Clause
// Time of a control cycle of the shipped methods that score trajectories, on one core, without the
// simulator: observations of their runs in 8 scenarios of discs are recorded, then played to them.
// Counter `cycle` is the processor time of a control cycle, in seconds.
#include <slalom/core/random.h>
#include <slalom/library/library_method.h>
#include <slalom/simulation/run_observer.h>
#include <slalom/simulation/simulate.h>

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace slalom {
namespace {

using Parameters = std::vector<std::pair<std::string, std::string>>;

constexpr int kWorlds = 8;

/// 10 m x 10 m with 20 discs between start and goal.
World world_of_discs(std::uint64_t seed) {
  RandomEngine random(seed);
  Primitives obstacles;
  for (int i = 0; i < 20; ++i)
    obstacles.discs.push_back({{uniform_real(random, 2, 8), uniform_real(random, 0.5, 9.5)},
                               uniform_real(random, 0.1, 0.4)});
  return {Scenario::continuous("discs", {0, 0, 10, 10}, obstacles, {1, 5, 0}, {9, 5}), 0.05};
}

struct Cycle {
  Observation observation;
  mrpt::obs::CObservation2DRangeScan scan;
};

/// A run as its method saw it.
class CycleRecorder : public RunObserver {
 public:
  NavigationTask task;
  std::vector<Cycle> cycles;

  void on_start(const NavigationTask& started) override { task = started; }
  void on_end(const SimulationResult&) override {}
  void on_cycle(const Observation& observation, const Command&,
                const mrpt::math::TPose2D&) override {
    cycles.push_back({observation, *observation.scan});
  }
};

void play(Method& method, CycleRecorder& run) {
  method.reset(run.task);
  for (Cycle& cycle : run.cycles) {
    cycle.observation.scan = &cycle.scan;
    benchmark::DoNotOptimize(method.step(cycle.observation));
  }
}

void play_runs(benchmark::State& state, const std::string& name, const Parameters& parameters) {
  RunSetup setup;
  setup.sensor.rays = 720;
  const std::unique_ptr<Method> method =
      plugin("libslalom_" + name + ".so", parameters)(setup.robot, setup.sensor);
  std::vector<CycleRecorder> runs(kWorlds);
  for (std::size_t i = 0; i < runs.size(); ++i)
    simulate(world_of_discs(i), setup, 1, *method, &runs[i]);
  std::size_t run = 0;
  double cycles = 0;
  for (auto _ : state) {
    play(*method, runs[run]);
    cycles += static_cast<double>(runs[run].cycles.size());
    run = (run + 1) % runs.size();
  }
  state.counters["cycle"] =
      benchmark::Counter(cycles, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(play_runs, mppi, "mppi", Parameters{});
BENCHMARK_CAPTURE(play_runs, trajectory_rollout, "trajectory_rollout", Parameters{});
BENCHMARK_CAPTURE(play_runs, dwa, "dwa", Parameters{});
BENCHMARK_CAPTURE(play_runs, dwa_guided, "dwa", Parameters{{"guidance", "1"}});

}  // namespace
}  // namespace slalom
