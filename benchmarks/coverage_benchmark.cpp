// SPDX-License-Identifier: BSD-3-Clause
/// Fills 10 bins x 20 scenarios of density, clearness and confinement, and a joint 6 x 6 map of
/// density and confinement; prints the tables with wall-clock time, processor time and memory.
///
///     coverage_benchmark [JOBS] [SEED] [MAX_EXTENT] [DESCRIPTORS...]
///
/// DESCRIPTORS: density, clearness, confinement or density,confinement; default: all of them.

#include <slalom/core/text.h>
#include <slalom/generation/coverage.h>

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <sys/resource.h>

namespace {

struct Usage {
  double cpu_seconds, peak_mb;
};

Usage usage() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {seconds(used.ru_utime) + seconds(used.ru_stime),
          static_cast<double>(used.ru_maxrss) / 1024};
}

void run(const std::string& descriptors, int jobs, std::uint64_t seed,
         const std::string& max_extent) {
  const std::string bins = descriptors.find(',') == std::string::npos ? "10" : "6";
  const auto ini =
      slalom::IniFile::from_text("[coverage]\ndescriptors = " + descriptors + "\nbins = " + bins +
                                 "\nper_bin = 20\nmax_extent = " + max_extent + "\n");
  const slalom::CoveragePlan plan =
      slalom::read_coverage_plan(ini, {"random", "poisson_forest", "cellular_automaton"});
  slalom::CoverageSettings task;
  task.seed = seed;
  task.jobs = jobs;
  const auto progress = slalom::make_silent_progress();
  const double cpu_before = usage().cpu_seconds;
  const auto begin = std::chrono::steady_clock::now();
  const slalom::CoverageResult result = slalom::cover(plan, task, *progress);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  const Usage after = usage();
  std::fputs(slalom::render_coverage(plan, result).c_str(), stdout);
  std::fputs(fmt::format("{:.1f} s wall-clock time, {:.1f} s processor time, {} threads, peak "
                         "memory so far {:.0f} MB\n\n",
                         wall.count(), after.cpu_seconds - cpu_before, jobs, after.peak_mb)
                 .c_str(),
             stdout);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int jobs = argc > 1 ? std::atoi(argv[1]) : 2;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const std::string max_extent = argc > 3 ? argv[3] : "200";
  std::vector<std::string> selected(argv + std::min(argc, 4), argv + argc);
  if (selected.empty()) selected = {"density", "clearness", "confinement", "density,confinement"};
  for (const std::string& descriptors : selected) run(descriptors, jobs, seed, max_extent);
}
