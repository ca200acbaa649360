// SPDX-License-Identifier: BSD-3-Clause
// Lock-step control cycles per second with a node on Cyclone DDS that commands for each scan of 181
// rays
// (`per_scan`), or from a timer behind the barrier (`barrier`): Method::step(), in two processes.
// For comparable figures run it with
//   --benchmark_repetitions=9 --benchmark_enable_random_interleaving=true
#include "places.h"
#include "private_network.h"

#include <slalom/ros2/ros2_method.h>

#include <benchmark/benchmark.h>

namespace slalom {
namespace {

void step(benchmark::State& state, const std::string& arguments, const std::string& barrier) {
  Ros2Options options;
  options.launch = "exec " + kCyclonePeer + " --stamped" + arguments;
  options.barrier = barrier;
  mrpt::obs::CObservation2DRangeScan scan;
  scan.resizeScan(181);
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) {
    scan.setScanRange(i, 2.0F + 0.01F * static_cast<float>(i));
    scan.setScanRangeValidity(i, true);
  }
  Observation observation;
  observation.scan = &scan;
  NavigationTask task;
  task.control_period = 0.1;
  const auto method = ros2_method(options)(RobotModel(), SensorModel());
  method->reset(task);
  method->settle(observation);
  for (auto _ : state) {
    benchmark::DoNotOptimize(method->step(observation));
    observation.time += task.control_period;
  }
  for (const auto& [id, count] : method->run_figures()) state.counters[id] = count;
  state.counters["cycles"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void per_scan(benchmark::State& state) {
  step(state, "", "");
}

void barrier(benchmark::State& state) {
  step(state, " --timer", "method");
}

BENCHMARK(per_scan)->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(barrier)->UseRealTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  slalom::enter_private_network();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
