// Time of scenario descriptors in random rooms of 400 x 400 cells of 0.05 m with 25 to 60 discs,
// from the scenario alone: its cells, distances, ray tables and shortest path are made anew each
// time. `first_three` is density, clearness and confinement, `all` every descriptor; `rasterise` is
// what making the cells takes, `distances`, `ray_tables` and `shortest_path` those, `alone/ID` one
// descriptor when all that it needs is there. Counters: median, 90 % quantile and largest processor
// time (ms) over the rooms, for each the least of all repetitions, so that other work on the
// machine counts little.
#include <slalom/core/random.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/references/exact_shortest.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kSize = 20, kResolution = 0.05;  // m
constexpr std::size_t kRooms = 20;

KnownPath path_in(const World& world) {
  const auto& start = world.scenario().start();
  std::string reason;
  const auto path =
      exact_shortest_path({world, 0.25, {start.x, start.y}, world.scenario().goal()}, 0.01, reason);
  return path ? KnownPath{path->path, path->length, ""} : KnownPath{{}, 0, reason};
}

DescriptorContext context_of(const World& world) {
  return {world, Footprint::disc(0.25), 8, search_once([&world] { return path_in(world); })};
}

Scenario random_room(RandomEngine& random) {
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

/// Rooms with a path for the robot.
const std::vector<Scenario>& rooms() {
  static const std::vector<Scenario> made = [] {
    std::vector<Scenario> rooms;
    RandomEngine random(1);
    while (rooms.size() < kRooms) {
      Scenario room = random_room(random);
      if (!path_in(World(room, kResolution)).path.empty()) rooms.push_back(std::move(room));
    }
    return rooms;
  }();
  return made;
}

/// Processor time of this thread, ms.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Times `act` in a fresh World of every room.
template <typename Prepare, typename Act>
void time_rooms(benchmark::State& state, Prepare prepare, Act act) {
  std::vector<double> milliseconds(rooms().size(), std::numeric_limits<double>::infinity());
  for (auto _ : state)
    for (std::size_t i = 0; i < rooms().size(); ++i) {
      const World world(rooms()[i], kResolution);
      const DescriptorContext context = context_of(world);
      prepare(context);
      const double begin = processor_time();
      act(context);
      milliseconds[i] = std::min(milliseconds[i], processor_time() - begin);
    }
  std::sort(milliseconds.begin(), milliseconds.end());
  state.counters["median_ms"] = milliseconds[milliseconds.size() / 2];
  state.counters["p90_ms"] = milliseconds[milliseconds.size() * 9 / 10];
  state.counters["max_ms"] = milliseconds.back();
}

void nothing(const DescriptorContext&) {}

void rasterise(benchmark::State& state) {
  time_rooms(state, nothing, [](const DescriptorContext& context) {
    benchmark::DoNotOptimize(context.world.occupancy().cells().data());
  });
}

void cells(const DescriptorContext& context) {
  context.world.occupancy();
}

void distances(benchmark::State& state) {
  time_rooms(state, cells, [](const DescriptorContext& context) {
    benchmark::DoNotOptimize(context.world.distance_field().centers().data());
  });
}

void ray_tables(benchmark::State& state) {
  time_rooms(state, cells, [](const DescriptorContext& context) {
    benchmark::DoNotOptimize(context.world.ray_caster().cast({1, 1}, 0, 1));
  });
}

void shortest_path(benchmark::State& state) {
  const auto with_distances = [](const DescriptorContext& context) {
    context.world.distance_field();
  };
  time_rooms(state, with_distances, [](const DescriptorContext& context) {
    benchmark::DoNotOptimize(context.shortest().length);
  });
}

void first_three(benchmark::State& state) {
  time_rooms(state, nothing, [](const DescriptorContext& context) {
    for (const std::string id : {"density", "clearness", "confinement"})
      benchmark::DoNotOptimize(descriptor(id).compute(context));
  });
}

void all(benchmark::State& state) {
  time_rooms(state, nothing, [](const DescriptorContext& context) {
    for (const auto& each : all_descriptors()) benchmark::DoNotOptimize(each->compute(context));
  });
}

void alone(benchmark::State& state, const Descriptor& wanted) {
  const auto prepare = [](const DescriptorContext& context) {
    context.world.distance_field();
    context.world.ray_caster();
    context.shortest();
  };
  time_rooms(state, prepare, [&](const DescriptorContext& context) {
    benchmark::DoNotOptimize(wanted.compute(context));
  });
}

const bool kRegistered = [] {
  for (const auto& each : all_descriptors())
    benchmark::RegisterBenchmark(("alone/" + each->info().id).c_str(),
                                 [&each](benchmark::State& state) { alone(state, *each); })
        ->Unit(benchmark::kMillisecond);
  return true;
}();

BENCHMARK(rasterise)->Unit(benchmark::kMillisecond);
BENCHMARK(distances)->Unit(benchmark::kMillisecond);
BENCHMARK(ray_tables)->Unit(benchmark::kMillisecond);
BENCHMARK(shortest_path)->Unit(benchmark::kMillisecond);
BENCHMARK(first_three)->Unit(benchmark::kMillisecond);
BENCHMARK(all)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace slalom
