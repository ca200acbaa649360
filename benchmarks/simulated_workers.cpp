// SPDX-License-Identifier: BSD-3-Clause
// How many workers one parent keeps busy: the runs of a result file again, in workers that sleep
// for the time that each took and send its record instead of computing it. Prints the time of the
// campaign as a fraction of the ideal and the parent's processor time per run; does not use Google
// Benchmark: simulated_workers RESULTS OUTPUT REPETITIONS WORKERS...
#include "wire.h"

#include <slalom/campaign/method_pool.h>
#include <slalom/core/wall_clock.h>
#include <slalom/io/result_file.h>
#include <slalom/workers/worker_pool.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <thread>
#include <vector>

namespace slalom {
namespace {

double own_processor_seconds() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::vector<RunFindings> recorded_runs(const ResultFile& file) {
  std::vector<RunFindings> runs;
  file.for_each_run([&](const RunRecord& run) {
    runs.push_back({run, file.read_timing(run), file.read_trajectory(run)});
  });
  return runs;
}

/// All that the parent of a campaign does for a run: it schedules, checks and stores it.
void simulate_campaign(const std::vector<RunFindings>& runs, const ResultFile& recorded,
                       const std::string& output, std::size_t repetitions, int workers) {
  ResultFile file = ResultFile::create(output, recorded.read_manifest(), recorded.descriptors(),
                                       recorded.metrics());
  const auto repeated = [&](std::size_t i) {
    RunFindings findings = runs[i % runs.size()];
    findings.record.repetition = static_cast<int>(i / runs.size());
    return findings;
  };
  const WorkItem item = [&](std::size_t i, SharedTaskLog&) {
    prctl(PR_SET_TIMERSLACK, 1);  // ns; by default sleeping takes 50 us longer
    const RunFindings findings = repeated(i);
    std::this_thread::sleep_for(std::chrono::duration<double>(findings.timing.wall_seconds));
    return to_wire(findings);
  };
  PoolOptions pool = method_pool({}, steady_seconds);
  pool.schedule.workers = workers;
  pool.schedule.ordered = false;
  RunFindings answer;
  pool.hooks.is_valid = [&](std::size_t i, const std::string& payload) {
    answer = run_findings_from_wire(payload);
    return answer.record.scenario_hash == runs[i % runs.size()].record.scenario_hash;
  };
  double committed = steady_seconds(), ideal = 0;
  for (const RunFindings& run : runs) ideal += run.timing.wall_seconds;
  const std::size_t count = runs.size() * repetitions;
  ideal *= static_cast<double>(repetitions) / workers;
  const double begin = steady_seconds(), begin_processor = own_processor_seconds();
  run_in_workers(
      count, pool, item,
      [&](std::size_t, WorkResult&&) {
        file.add_run(answer.record, answer.timing, answer.trajectory);
        if (steady_seconds() - committed < 2) return;
        file.commit();
        committed = steady_seconds();
      },
      nullptr);
  file.commit();
  const double elapsed = steady_seconds() - begin;
  std::printf("%3d workers  %zu runs  %6.2f s  ideal %6.2f s  ratio %.2f  parent %.0f us per run\n",
              workers, count, elapsed, ideal, ideal / elapsed,
              1e6 * (own_processor_seconds() - begin_processor) / static_cast<double>(count));
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fprintf(stderr, "usage: simulated_workers RESULTS OUTPUT REPETITIONS WORKERS...\n");
    return 2;
  }
  const slalom::ResultFile recorded = slalom::ResultFile::open(argv[1]);
  const std::vector<slalom::RunFindings> runs = slalom::recorded_runs(recorded);
  for (int i = 4; i < argc; ++i)
    slalom::simulate_campaign(runs, recorded, argv[2], static_cast<std::size_t>(std::atoi(argv[3])),
                              std::atoi(argv[i]));
}
