// SPDX-License-Identifier: BSD-3-Clause
// Selections from a list of 100,000 scenarios, with and without an index; and the cost of creating
// and reading it.
#include <slalom/core/random.h>
#include <slalom/io/scenario_list.h>

#include <benchmark/benchmark.h>

#include <filesystem>
#include <unistd.h>

namespace {

using namespace slalom;

constexpr std::uint64_t kScenarios = 100000;

DescriptorView view() {
  return {{"density", {{"density", 1, ""}, {"density", 1, "resolution=0.05"}}},
          {"confinement", {{"confinement", 1, ""}, {"confinement", 1, "resolution=0.05"}}}};
}

/// Adds numbered scenarios with a few discs and synthetic values: only the list is timed.
void fill(ScenarioList& list) {
  RandomEngine engine(1);
  for (std::uint64_t i = 0; i < kScenarios; ++i) {
    Primitives obstacles;
    for (int disc = 0; disc < 8; ++disc)
      obstacles.discs.push_back({{uniform_real(engine, 2, 8), uniform_real(engine, 2, 8)}, 0.2});
    const auto scenario = Scenario::continuous("room_" + std::to_string(i), {0, 0, 10, 10},
                                               obstacles, {1, 1, 0}, {9, 9});
    list.add(scenario, {"random", i, {}});
    for (const auto& [id, keys] : view())
      list.store_value(scenario.hash(), {keys[1], Value::of(uniform_real(engine, 0, 1))});
  }
}

/// A list created once for all benchmarks and removed at exit.
class BigList {
 public:
  BigList()
      : path_((std::filesystem::temp_directory_path() /
               ("slalom_list_" + std::to_string(getpid()) + ".scenarios"))
                  .string()) {
    ScenarioList::write(path_, fill);
  }
  ~BigList() { std::filesystem::remove(path_); }
  BigList(const BigList&) = delete;
  BigList& operator=(const BigList&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

const std::string& big_list() {
  static const BigList list;
  return list.path();
}

void select(benchmark::State& state, const char* where, bool with_index) {
  ScenarioList list = ScenarioList::open(big_list());
  if (with_index)
    list.create_index({"by_density", "density", view().at("density"), {0, 0.1, 0.2, 0.4, 1}});
  ListSelection selection;
  selection.view = view();
  selection.where = parse_selection(where, list.vocabulary({"density", "confinement"}));
  std::size_t selected = 0;
  for (auto _ : state) selected = list.count(selection);
  state.counters["selected"] = static_cast<double>(selected);
  if (with_index) list.drop_index("by_density");
}

constexpr const char* kTenth = "density >= 0.1 and density < 0.2 and not (confinement > 0.8)";
constexpr const char* kFew = "density in [0.1, 0.101]";

BENCHMARK_CAPTURE(select, tenth_without_index, kTenth, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(select, tenth_with_index, kTenth, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(select, few_without_index, kFew, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(select, few_with_index, kFew, true)->Unit(benchmark::kMillisecond);

void create_index(benchmark::State& state) {
  ScenarioList list = ScenarioList::open(big_list());
  for (auto _ : state) {
    list.create_index({"x", "density", view().at("density"), {0, 1}});
    state.PauseTiming();
    list.drop_index("x");
    state.ResumeTiming();
  }
}
BENCHMARK(create_index)->Unit(benchmark::kMillisecond);

void read_every_scenario(benchmark::State& state) {
  const ScenarioList list = ScenarioList::open(big_list());
  for (auto _ : state)
    list.for_each({}, [&](const ScenarioList::Entry& entry) {
      benchmark::DoNotOptimize(list.read(entry.hash));
      return true;
    });
}
BENCHMARK(read_every_scenario)->Unit(benchmark::kMillisecond);

void write_list(benchmark::State& state) {
  const std::string path = big_list() + ".new";
  for (auto _ : state) ScenarioList::write(path, fill);
  std::filesystem::remove(path);
}
BENCHMARK(write_list)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
