// SPDX-License-Identifier: BSD-3-Clause
// Updates of people per second on one core, without a robot: people who walk to and fro for a
// minute, by model and number of people: in an empty `square` of 0.2 people per square meter, and
// through `rooms` with doors on a grid of 400 x 400 cells of 0.05 m. Counter `updates` is updates
// of one person per second.
#include <slalom/generation/rooms.h>
#include <slalom/generation/sample_people.h>
#include <slalom/people/crowd.h>

#include <benchmark/benchmark.h>

#include <cmath>

namespace slalom {
namespace {

constexpr double kResolution = 0.05;  // m
constexpr int kUpdates = 600;

Scenario rooms(int /*people*/) {
  RoomsOptions options;
  options.width = options.height = 20;
  RandomEngine engine(7);
  return make_generator(options)->generate("rooms", engine);
}

Scenario square(int people) {
  constexpr double kDensity = 0.2;  // per square meter
  const double size = std::sqrt(people / kDensity);
  return Scenario::continuous("square", {0, 0, size, size}, {}, {0.5, 0.5, 0},
                              {size - 0.5, size - 0.5});
}

void walk(benchmark::State& state, Scenario (*make)(int), PeopleModel model) {
  PeopleOptions options;
  options.count = static_cast<int>(state.range(0));
  const World world(make(options.count), kResolution);
  RandomEngine engine(7);
  PeopleSettings settings;
  settings.model = model;
  const Crowd start(world, sample_people(world, 0.25, options, engine), settings);
  for (auto _ : state) {
    Crowd crowd = start;
    for (int i = 0; i < kUpdates; ++i) {
      crowd.decide();
      crowd.move();
    }
    benchmark::DoNotOptimize(crowd.states());
  }
  state.counters["updates"] =
      benchmark::Counter(static_cast<double>(state.iterations() * kUpdates * options.count),
                         benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(walk, square_speed, square, PeopleModel::Speed)->Arg(5)->Arg(20)->Arg(100);
BENCHMARK_CAPTURE(walk, square_orca, square, PeopleModel::Orca)->Arg(5)->Arg(20)->Arg(100);
BENCHMARK_CAPTURE(walk, rooms_speed, rooms, PeopleModel::Speed)->Arg(5)->Arg(20)->Arg(100);
BENCHMARK_CAPTURE(walk, rooms_orca, rooms, PeopleModel::Orca)->Arg(5)->Arg(20)->Arg(100);

}  // namespace
}  // namespace slalom
