// SPDX-License-Identifier: BSD-3-Clause
// Planning time of reference paths in random scenarios of 400 x 400 cells of 0.05 m with 25 to 60
// discs, for a robot radius of 0.25 m. `exact` is the exact shortest path; `safest` the path on the
// Voronoi diagram; its peer `mrpt_voronoi` is only buildVoronoiDiagram(), on the same grids. The
// others are OMPL's planners, stopped at 1 % and 0.5 % above the certified lower bound, or after a
// second. Counters: median and maximum processor time over the scenarios (ms), and `reached`, the
// fraction of scenarios in which the gap was reached. The tables of a scenario are precomputed.
// `arrival` is the earliest arrival at 1 m/s among the given number of moving obstacles that walk
// at 0.5 to 1.5 m/s between random positions, through static obstacles too; it is reached where the
// gap is at most 10 %.
#include "processor_time.h"

#include <slalom/core/random.h>
#include <slalom/ompl/ompl_planner.h>
#include <slalom/references/earliest_arrival.h>
#include <slalom/references/exact_shortest.h>
#include <slalom/references/safest_path.h>

#include <benchmark/benchmark.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <deque>
#include <map>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kSize = 20, kResolution = 0.05, kRadius = 0.25;  // m
constexpr std::size_t kScenarios = 24;

Scenario random_scenario(RandomEngine& random) {
  Primitives obstacles;
  const TPoint2D start(1, 1), goal(kSize - 1, kSize - 1);
  const int count = uniform_int(random, 25, 60);
  while (static_cast<int>(obstacles.discs.size()) < count) {
    const Disc disc{{uniform_real(random, 0, kSize), uniform_real(random, 0, kSize)},
                    uniform_real(random, 0.2, 1.2)};
    const double clear = disc.radius + kRadius + 0.1;
    if ((disc.center - start).norm() > clear && (disc.center - goal).norm() > clear)
      obstacles.discs.push_back(disc);
  }
  const Scenario discs =
      Scenario::continuous("discs", {0, 0, kSize, kSize}, obstacles, {start.x, start.y, 0}, goal);
  return convert(discs, Representation::Grid, kResolution);
}

PlanningProblem problem_of(const World& world) {
  const auto& start = world.scenario().start();
  return {world, kRadius, {start.x, start.y}, world.scenario().goal()};
}

struct Problem {
  const World& world;
  References exact;
};

/// Solvable scenarios with their tables and exact references.
const std::vector<Problem>& problems() {
  static std::deque<World> worlds;
  static const std::vector<Problem> result = [] {
    std::vector<Problem> problems;
    RandomEngine random(1);
    while (problems.size() < kScenarios) {
      worlds.emplace_back(random_scenario(random), kResolution);
      References exact = compute_references(problem_of(worlds.back()), nullptr, 0.01, 1);
      if (exact.shortest)
        problems.push_back({worlds.back(), std::move(exact)});
      else
        worlds.pop_back();
    }
    return problems;
  }();
  return result;
}

/// Times `solve` in every scenario; it returns whether the gap was reached.
template <typename Solve>
void time_problems(benchmark::State& state, Solve solve) {
  std::vector<double> milliseconds;
  std::size_t reached = 0;
  problems();
  for (auto _ : state)
    for (const Problem& problem : problems()) {
      const double begin = processor_milliseconds();
      reached += solve(problem) ? 1 : 0;
      milliseconds.push_back(processor_milliseconds() - begin);
    }
  std::sort(milliseconds.begin(), milliseconds.end());
  state.counters["median_ms"] = milliseconds[milliseconds.size() / 2];
  state.counters["max_ms"] = milliseconds.back();
  state.counters["reached"] =
      static_cast<double>(reached) / static_cast<double>(milliseconds.size());
}

void exact(benchmark::State& state) {
  time_problems(state, [](const Problem& problem) {
    std::string reason;
    return exact_shortest_path(problem_of(problem.world), reason).has_value();
  });
}

void safest(benchmark::State& state) {
  time_problems(state, [](const Problem& problem) {
    std::string reason;
    return safest_path(problem_of(problem.world), reason).has_value();
  });
}

void mrpt_voronoi(benchmark::State& state) {
  time_problems(state, [](const Problem& problem) {
    mrpt::maps::COccupancyGridMap2D map = *problem.world.scenario().grid_map();
    // It reads beyond the map at its border: an inset avoids that.
    constexpr int kInset = 4, kCells = static_cast<int>(kSize / kResolution);
    map.buildVoronoiDiagram(0.5F, static_cast<float>(kRadius), kInset, kCells - kInset, kInset,
                            kCells - kInset);
    return true;
  });
}

Movers random_walkers(RandomEngine& random, int count, const TPoint2D& start) {
  constexpr int kWaypoints = 30;
  Movers movers;
  while (static_cast<int>(movers.size()) < count) {
    Mover mover{std::to_string(movers.size()), uniform_real(random, 0.2, 0.4), {}};
    for (int i = 0; i < kWaypoints; ++i) {
      const TPoint2D p(uniform_real(random, 0, kSize), uniform_real(random, 0, kSize));
      const double t =
          i == 0 ? 0
                 : mover.waypoints.back().t + (p - mover.waypoints.back().position).norm() /
                                                  uniform_real(random, 0.5, 1.5);
      mover.waypoints.push_back({t, p});
    }
    if ((mover.waypoints.front().position - start).norm() > 2) movers.push_back(mover);
  }
  return movers;
}

void arrival(benchmark::State& state) {
  static std::deque<World> moving;
  std::map<const World*, const World*> with_movers;
  RandomEngine random(2);
  for (const Problem& problem : problems()) {
    const TPoint2D start(problem.world.scenario().start());
    const Movers movers = random_walkers(random, static_cast<int>(state.range(0)), start);
    moving.emplace_back(problem.world.scenario().with_movers(movers), kResolution);
    moving.back().distance_field();
    with_movers[&problem.world] = &moving.back();
  }
  time_problems(state, [&](const Problem& problem) {
    std::string reason;
    const auto found = earliest_arrival(problem_of(*with_movers.at(&problem.world)),
                                        *problem.exact.shortest, {1.0, 0.2, 100}, reason);
    return found && found->certificate.gap() <= 0.1;
  });
}

void ompl(benchmark::State& state, const std::string& name, double gap) {
  OmplOptions options;
  options.planner = name;
  options.gap = gap;
  options.max_iterations = 1000000000;
  options.max_time = 1;
  const auto planner = make_ompl_planner(options);
  std::uint64_t seed = 0;
  time_problems(state, [&](const Problem& problem) {
    std::string reason;
    const auto path = planner->plan(problem_of(problem.world), problem.exact, ++seed, reason);
    return path && length(*path) <= (1 + gap) * problem.exact.shortest->certificate.lower_bound;
  });
}

BENCHMARK(exact)->Unit(benchmark::kMillisecond);
BENCHMARK(safest)->Unit(benchmark::kMillisecond);
BENCHMARK(mrpt_voronoi)->Unit(benchmark::kMillisecond);
BENCHMARK(arrival)->Arg(0)->Arg(5)->Arg(20)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ompl, InformedRRTstar_1, "InformedRRTstar", 0.01)->Iterations(1);
BENCHMARK_CAPTURE(ompl, InformedRRTstar_05, "InformedRRTstar", 0.005)->Iterations(1);
BENCHMARK_CAPTURE(ompl, PRMstar_1, "PRMstar", 0.01)->Iterations(1);
BENCHMARK_CAPTURE(ompl, PRMstar_05, "PRMstar", 0.005)->Iterations(1);
BENCHMARK_CAPTURE(ompl, BITstar_1, "BITstar", 0.01)->Iterations(1);
BENCHMARK_CAPTURE(ompl, BITstar_05, "BITstar", 0.005)->Iterations(1);
BENCHMARK_CAPTURE(ompl, RRTstar_1, "RRTstar", 0.01)->Iterations(1);
BENCHMARK_CAPTURE(ompl, RRTstar_05, "RRTstar", 0.005)->Iterations(1);
BENCHMARK_CAPTURE(ompl, ABITstar_1, "ABITstar", 0.01)->Iterations(1);
BENCHMARK_CAPTURE(ompl, ABITstar_05, "ABITstar", 0.005)->Iterations(1);
BENCHMARK_CAPTURE(ompl, AITstar_1, "AITstar", 0.01)->Iterations(1);
BENCHMARK_CAPTURE(ompl, AITstar_05, "AITstar", 0.005)->Iterations(1);
BENCHMARK_CAPTURE(ompl, FMT_1, "FMT", 0.01)->Iterations(1);
BENCHMARK_CAPTURE(ompl, FMT_05, "FMT", 0.005)->Iterations(1);

}  // namespace
}  // namespace slalom
