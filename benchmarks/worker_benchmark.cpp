// The cost of a crash in a campaign beyond its own run: jobs that crash their worker, so that each
// needs a new process, compared with jobs that end normally in a reused one. Counter `tasks` is
// jobs per second, `processor_ms` the processor time of a job in all processes; the difference of
// the times per job is the cost of a restart. The process allocates as much memory as the tables of
// a large map, since forking copies page tables. It is in small pages before the first job.
#include <slalom/campaign/worker_pool.h>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <sys/resource.h>

namespace slalom {
namespace {

constexpr std::size_t kTasks = 50;
constexpr std::size_t kTables = 200U << 20U;  // bytes

/// Processor time of this process and of its children that have ended; ms.
double processor_ms() {
  double sum = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used = {};
    getrusage(who, &used);
    for (const timeval& time : {used.ru_utime, used.ru_stime})
      sum += static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_usec) * 1e-3;
  }
  return sum;
}

void run_tasks(benchmark::State& state, bool crash) {
  const std::string tables(kTables, 'x');
  PoolOptions options;
  options.log_size = 20000;
  const double before = processor_ms();
  for (auto _ : state)
    run_in_workers(
        kTasks, options,
        [&](std::size_t i, SharedTaskLog&) {
          if (crash) std::_Exit(1);
          return std::string(1, tables[i]);
        },
        [](std::size_t, WorkResult&&) {}, nullptr);
  const auto tasks = static_cast<double>(kTasks * state.iterations());
  state.counters["processor_ms"] = (processor_ms() - before) / tasks;
  state.counters["tasks"] = benchmark::Counter(tasks, benchmark::Counter::kIsRate);
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
