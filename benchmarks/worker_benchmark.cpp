// What a crash costs a campaign beyond its own run: tasks that crash their worker, so that each
// next one needs a new process, beside tasks that end well in one that stays. Counter `tasks` is
// tasks per second; the difference of their times per task is the price of a restart. The process
// holds as much memory as one with the tables of a large map does, since forking copies page
// tables.
#include <slalom/campaign/worker_pool.h>

#include <benchmark/benchmark.h>

#include <csignal>

namespace slalom {
namespace {

constexpr std::size_t kTasks = 50;
constexpr std::size_t kTables = 200U << 20U;  // bytes

void run_tasks(benchmark::State& state, bool crash) {
  const std::string tables(kTables, 'x');
  PoolOptions options;
  options.notes_size = 20000;
  for (auto _ : state)
    run_in_workers(
        kTasks, options,
        [&](std::size_t i, TaskNotes&) {
          if (crash) std::raise(SIGKILL);
          return std::string(1, tables[i]);
        },
        [](std::size_t, TaskResult&&) {}, nullptr);
  state.counters["tasks"] = benchmark::Counter(static_cast<double>(kTasks * state.iterations()),
                                               benchmark::Counter::kIsRate);
}

void tasks_that_end(benchmark::State& state) {
  run_tasks(state, false);
}

void tasks_that_crash(benchmark::State& state) {
  run_tasks(state, true);
}

BENCHMARK(tasks_that_end)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(tasks_that_crash)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace slalom
