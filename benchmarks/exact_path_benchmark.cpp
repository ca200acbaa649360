// SPDX-License-Identifier: BSD-3-Clause
// Processor time of the exact shortest path of a disc in the scenarios of lists, such as imported
// maps:
//   slalom-scenarios import FOLDER_OR_MAPS -o maps.scenarios --pairs 10
//   exact_path_benchmark RADIUS maps.scenarios...
// Per list: the least time of 7 in each scenario; median, 90 % quantile and maximum over those with
// a path, and the maximum over those where it is proved that there is none. The occupancy of a
// scenario and its distance field are precomputed, the tables of the search are not. Does not use
// Google Benchmark.
#include "processor_time.h"

#include <slalom/core/error.h>
#include <slalom/io/scenario_list.h>
#include <slalom/references/exact_shortest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <vector>

namespace {

constexpr double kResolution = 0.05;  // m, of scenarios that are no grids

struct Times {
  std::vector<double> solved, unsolvable;  ///< ms
};

void time_scenario(const slalom::Scenario& scenario, double radius, Times& times) {
  const slalom::World world(scenario, kResolution);
  const auto& start = scenario.start();
  const slalom::PlanningProblem problem{world, radius, {start.x, start.y}, scenario.goal()};
  double least = std::numeric_limits<double>::infinity();
  bool solved = false;
  for (int i = 0; i < 7; ++i) {
    std::string reason;
    const double begin = slalom::processor_milliseconds();
    solved = slalom::exact_shortest_path(problem, reason).has_value();
    least = std::min(least, slalom::processor_milliseconds() - begin);
  }
  (solved ? times.solved : times.unsolvable).push_back(least);
}

std::string quantile(std::vector<double> values, double q) {
  if (values.empty()) return "-";
  std::sort(values.begin(), values.end());
  return fmt::format("{:.2f}",
                     values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))]);
}

void run(const std::string& path, double radius) {
  const auto list = slalom::ScenarioList::open(path);
  Times times;
  for (const auto& entry : list.entries()) time_scenario(list.read(entry.hash), radius, times);
  fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", path, times.solved.size(),
             quantile(times.solved, 0.5), quantile(times.solved, 0.9), quantile(times.solved, 1),
             times.unsolvable.size(), quantile(times.unsolvable, 1));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 3) throw std::invalid_argument("usage: exact_path_benchmark RADIUS LIST...");
  const double radius = std::strtod(argv[1], nullptr);
  if (!(radius > 0)) throw std::invalid_argument("RADIUS must be a positive number of meters");
  fmt::print(
      "| list | solved | median, ms | 90 %, ms | maximum, ms | no path | maximum, ms "
      "|\n|---|---|---|---|---|---|---|\n");
  for (int i = 2; i < argc; ++i) run(argv[i], radius);
  return 0;
} catch (const std::exception& e) {
  fmt::print(stderr, "exact_path_benchmark: {}\n", e.what());
  return 1;
}
