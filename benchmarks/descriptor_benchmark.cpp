// SPDX-License-Identifier: BSD-3-Clause
// Time of scenario descriptors in random scenarios of 400 x 400 cells of 0.05 m with 25 to 60
// discs, starting from the scenario: cells, distances, ray tables and shortest path are recomputed
// each time. `first_three` is density, clearness and confinement, `all` every descriptor;
// `rasterize`, `distances`, `ray_tables` and `shortest_path` are the times of these steps,
// `alone/ID` that of one descriptor with precomputed inputs. Counters: median, 90 % quantile and
// maximum processor time (ms) over the scenarios, for each the minimum of all repetitions, to
// reduce the influence of other load.
#include "processor_time.h"

#include <slalom/core/random.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/references/exact_shortest.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kSize = 20, kResolution = 0.05;  // m
constexpr std::size_t kScenarios = 20;

KnownPath path_in(const World& world) {
  const auto& start = world.scenario().start();
  std::string reason;
  const auto path =
      exact_shortest_path({world, 0.25, {start.x, start.y}, world.scenario().goal()}, reason);
  return path ? KnownPath{path->path, path->length, ""} : KnownPath{{}, 0, reason};
}

DescriptorContext context_of(const World& world) {
  return {world, Footprint::disc(0.25), 8, search_once([&world] { return path_in(world); })};
}

Scenario random_scenario(RandomEngine& random) {
  Primitives obstacles;
  const TPoint2D start(1, 1), goal(kSize - 1, kSize - 1);
  const int count = uniform_int(random, 25, 60);
  while (static_cast<int>(obstacles.discs.size()) < count) {
    const Disc disc{{uniform_real(random, 0, kSize), uniform_real(random, 0, kSize)},
                    uniform_real(random, 0.2, 1.2)};
    const double clear = disc.radius + 0.35;
    if ((disc.center - start).norm() > clear && (disc.center - goal).norm() > clear)
      obstacles.discs.push_back(disc);
  }
  return Scenario::continuous("discs", {0, 0, kSize, kSize}, obstacles, {start.x, start.y, 0},
                              goal);
}

/// Scenarios with a path for the robot.
const std::vector<Scenario>& scenarios() {
  static const std::vector<Scenario> result = [] {
    std::vector<Scenario> scenarios;
    RandomEngine random(1);
    while (scenarios.size() < kScenarios) {
      Scenario scenario = random_scenario(random);
      if (!path_in(World(scenario, kResolution)).path.empty())
        scenarios.push_back(std::move(scenario));
    }
    return scenarios;
  }();
  return result;
}

/// Times `act` in a new World of every scenario.
template <typename Prepare, typename Act>
void time_scenarios(benchmark::State& state, Prepare prepare, Act act) {
  std::vector<double> milliseconds(scenarios().size(), std::numeric_limits<double>::infinity());
  for (auto _ : state)
    for (std::size_t i = 0; i < scenarios().size(); ++i) {
      const World world(scenarios()[i], kResolution);
      const DescriptorContext context = context_of(world);
      prepare(context);
      const double begin = processor_milliseconds();
      act(context);
      milliseconds[i] = std::min(milliseconds[i], processor_milliseconds() - begin);
    }
  std::sort(milliseconds.begin(), milliseconds.end());
  state.counters["median_ms"] = milliseconds[milliseconds.size() / 2];
  state.counters["p90_ms"] = milliseconds[milliseconds.size() * 9 / 10];
  state.counters["max_ms"] = milliseconds.back();
}

void nothing(const DescriptorContext&) {}

void rasterize(benchmark::State& state) {
  time_scenarios(state, nothing, [](const DescriptorContext& context) {
    benchmark::DoNotOptimize(context.world.occupancy().cells().data());
  });
}

void cells(const DescriptorContext& context) {
  context.world.occupancy();
}

void distances(benchmark::State& state) {
  time_scenarios(state, cells, [](const DescriptorContext& context) {
    benchmark::DoNotOptimize(context.world.distance_field().centers().data());
  });
}

void ray_tables(benchmark::State& state) {
  time_scenarios(state, cells, [](const DescriptorContext& context) {
    benchmark::DoNotOptimize(context.world.ray_caster().cast({1, 1}, 0, 1));
  });
}

void shortest_path(benchmark::State& state) {
  const auto with_distances = [](const DescriptorContext& context) {
    context.world.distance_field();
  };
  time_scenarios(state, with_distances, [](const DescriptorContext& context) {
    benchmark::DoNotOptimize(context.shortest().length);
  });
}

void first_three(benchmark::State& state) {
  time_scenarios(state, nothing, [](const DescriptorContext& context) {
    for (const std::string id : {"density", "clearness", "confinement"})
      benchmark::DoNotOptimize(descriptor(id).compute(context));
  });
}

void all(benchmark::State& state) {
  time_scenarios(state, nothing, [](const DescriptorContext& context) {
    for (const auto& each : all_descriptors()) benchmark::DoNotOptimize(each.compute(context));
  });
}

void alone(benchmark::State& state, const Descriptor& descriptor) {
  const auto prepare = [](const DescriptorContext& context) {
    context.world.distance_field();
    context.world.ray_caster();
    context.shortest();
  };
  time_scenarios(state, prepare, [&](const DescriptorContext& context) {
    benchmark::DoNotOptimize(descriptor.compute(context));
  });
}

const bool kRegistered = [] {
  for (const auto& each : all_descriptors())
    benchmark::RegisterBenchmark(("alone/" + each.info.id).c_str(), [&each](
                                                                        benchmark::State& state) {
      alone(state, each);
    })->Unit(benchmark::kMillisecond);
  return true;
}();

BENCHMARK(rasterize)->Unit(benchmark::kMillisecond);
BENCHMARK(distances)->Unit(benchmark::kMillisecond);
BENCHMARK(ray_tables)->Unit(benchmark::kMillisecond);
BENCHMARK(shortest_path)->Unit(benchmark::kMillisecond);
BENCHMARK(first_three)->Unit(benchmark::kMillisecond);
BENCHMARK(all)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace slalom
