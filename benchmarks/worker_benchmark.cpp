// SPDX-License-Identifier: BSD-3-Clause
// The cost of a crash in a campaign beyond its own run: jobs that crash their worker, so that each
// needs a new process, compared with jobs that end normally in a reused one. Counter `tasks` is
// jobs per second; the difference of the times per job is the cost of a restart. The process
// allocates as much memory as the tables of a large map, since forking copies page tables.
#include <slalom/workers/worker_pool.h>

#include <benchmark/benchmark.h>

#include <cstdlib>

namespace slalom {
namespace {

constexpr std::size_t kTasks = 50;
constexpr std::size_t kTables = 200U << 20U;  // bytes

void run_tasks(benchmark::State& state, bool crash) {
  const std::string tables(kTables, 'x');
  PoolOptions options;
  options.log_size = 20000;
  for (auto _ : state)
    run_in_workers(
        kTasks, options,
        [&](std::size_t i, SharedTaskLog&) {
          if (crash) std::_Exit(1);
          return std::string(1, tables[i]);
        },
        [](std::size_t, WorkResult&&) {}, nullptr);
  state.counters["tasks"] = benchmark::Counter(static_cast<double>(kTasks * state.iterations()),
                                               benchmark::Counter::kIsRate);
}

void jobs_that_end(benchmark::State& state) {
  run_tasks(state, false);
}

void jobs_that_crash(benchmark::State& state) {
  run_tasks(state, true);
}

BENCHMARK(jobs_that_end)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(jobs_that_crash)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace slalom
