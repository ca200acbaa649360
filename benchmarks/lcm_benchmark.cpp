// SPDX-License-Identifier: BSD-3-Clause
// Lock-step control cycles per second over LCM with 181 rays, against bare LCM round trips in the
// same run: 181 floats one way, two doubles back, in two processes. `lcm_lockstep` is
// Method::step() with a method that slalom::serve_method() hosts, `bare_lcm` only publish() and
// handle(), `in_process` the same method called directly. For comparable figures run it with
//   --benchmark_repetitions=9 --benchmark_enable_random_interleaving=true
#include "private_network.h"

#include <slalom/core/program_path.h>
#include <slalom/lcm/lcm_method.h>
#include <slalom/lcm/method_host.h>

#include <benchmark/benchmark.h>
#include <lcm/lcm-cpp.hpp>

#include <csignal>
#include <sys/prctl.h>
#include <sys/wait.h>

namespace slalom {
namespace {

constexpr int kRays = 181;
constexpr char kHost[] = "--host";  // argument to run this program as the method's process

/// Reads every range, the minimum work of a method.
class Nearest : public Method {
 public:
  void reset(const NavigationTask&) override {}
  Command step(const Observation& observation) override {
    float nearest = observation.scan->maxRange;
    for (std::size_t i = 0; i < observation.scan->getScanSize(); ++i)
      nearest = std::min(nearest, observation.scan->getScanRange(i));
    return {0.1 * nearest, 0};
  }
};

int host() {
  MethodHost host("nearest", [](const hello_t&) { return std::make_unique<Nearest>(); });
  serve_method(host, std::getenv("SLALOM_LCM_URL"), std::getenv("SLALOM_LCM_CHANNEL"),
               [] { return false; });
  return 0;
}

/// An observation and its scan.
struct ScanObservation {
  ScanObservation() {
    scan.maxRange = 8;
    scan.resizeScan(kRays);
    for (int i = 0; i < kRays; ++i)
      scan.setScanRange(static_cast<std::size_t>(i), 2.0F + 0.01F * static_cast<float>(i));
    observation.scan = &scan;
  }
  mrpt::obs::CObservation2DRangeScan scan;
  Observation observation;
};

void count_cycles(benchmark::State& state) {
  state.counters["cycles"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void in_process(benchmark::State& state) {
  const ScanObservation input;
  Nearest method;
  for (auto _ : state) benchmark::DoNotOptimize(method.step(input.observation));
  count_cycles(state);
}

void lcm_lockstep(benchmark::State& state) {
  const IniFile ini = IniFile::from_text("[method.a]\nadapter = lcm\nlaunch = exec '" +
                                         program_path() + "' " + kHost + "\n");
  const ScanObservation input;
  const auto method = read_lcm_method(ini, "method.a")(RobotModel(), SensorModel());
  method->reset(NavigationTask());
  for (auto _ : state) benchmark::DoNotOptimize(method->step(input.observation));
  count_cycles(state);
}

bool wait(lcm::LCM& lcm, bool blocking) {
  return blocking ? lcm.handle() == 0 : lcm.handleTimeout(100) >= 0;
}

/// Responds with two doubles to every message.
class Echo {
 public:
  [[noreturn]] static void serve(bool blocking) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    lcm::LCM lcm(kLcmUrl);
    Echo echo(lcm);
    lcm.subscribeFunction("BARE_OUT", answer, &echo);
    while (wait(lcm, blocking)) continue;
    _exit(1);
  }

 private:
  explicit Echo(lcm::LCM& lcm) : lcm_(lcm) {}
  static void answer(const lcm::ReceiveBuffer* buffer, const std::string&, Echo* echo) {
    echo->lcm_.publish("BARE_BACK", buffer->data, 2 * sizeof(double));
  }
  lcm::LCM& lcm_;
};

void count_message(const lcm::ReceiveBuffer*, const std::string&, int* received) {
  ++*received;
}

void exchange(benchmark::State& state, bool blocking) {
  const pid_t echo = fork();
  if (echo == 0) Echo::serve(blocking);
  {
    lcm::LCM lcm(kLcmUrl);
    int received = 0;
    lcm.subscribeFunction("BARE_BACK", count_message, &received);
    const std::vector<float> ranges(kRays, 2.0F);
    const auto send = [&] {
      lcm.publish("BARE_OUT", ranges.data(), static_cast<unsigned>(ranges.size() * sizeof(float)));
    };
    while (received == 0) {  // the echo process is starting
      send();
      lcm.handleTimeout(50);
    }
    while (lcm.handleTimeout(100) > 0) continue;
    for (auto _ : state) {
      send();
      wait(lcm, blocking);
    }
  }
  kill(echo, SIGKILL);
  waitpid(echo, nullptr, 0);
  count_cycles(state);
}

void bare_lcm(benchmark::State& state) {
  exchange(state, false);
}

void bare_lcm_blocking(benchmark::State& state) {
  exchange(state, true);
}

BENCHMARK(bare_lcm_blocking)->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(bare_lcm)->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(lcm_lockstep)->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(in_process)->UseRealTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == slalom::kHost) return slalom::host();
  slalom::enter_private_network();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
