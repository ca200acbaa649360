// SPDX-License-Identifier: BSD-3-Clause
// Searches for planted defects (tests/modules/inquiry/falsification/plugins/planted.cpp), as tables
// in Markdown: how often each is hit in random candidates, and when probing finds it. Times are of
// the processor, of one core.
//   falsification_benchmark random CANDIDATES [SEED]
//   falsification_benchmark probe RUNS SEEDS [DEFECT]
//   falsification_benchmark shrink FAILURES [DEFECT]
// The last one shrinks up to FAILURES of each defect, and counts how many kinds of them are
// different in the facts of which clusters are made.
#include "planted_methods.h"
#include "search_batch.h"

#include <slalom/campaign/campaign.h>
#include <slalom/core/random.h>
#include <slalom/core/text.h>
#include <slalom/falsification/candidates.h>
#include <slalom/falsification/clusters.h>
#include <slalom/falsification/search.h>
#include <slalom/falsification/shrink.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <exception>
#include <set>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace slalom {
namespace {

struct Planting {
  const char* defect;
  bool has_memory;
};

/// In the order of the bits of planted_defects_begun.
constexpr std::array kPlantings = {Planting{"tie", false},
                                   Planting{"fine_tie", false},
                                   Planting{"narrow_squeeze", false},
                                   Planting{"fine_squeeze", false},
                                   Planting{"fast_and_near", false},
                                   Planting{"goal_behind", false},
                                   Planting{"needle", false},
                                   Planting{"beside_wall", true},
                                   Planting{"overflow", true},
                                   Planting{"after_turn", true},
                                   Planting{"cycle_128", true}};

/// CPU time of this process and of its workers that ended.
double cpu_seconds() {
  double seconds = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime})
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return seconds;
}

double median(std::vector<double> values) {
  if (values.empty()) return NAN;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

SearchOptions options_of(std::uint64_t seed) {
  SearchOptions options;
  options.seed = seed;
  options.outcomes = severe_outcomes();
  return options;
}

bool is_severe(Outcome outcome) {
  const auto severe = severe_outcomes();
  return std::find(severe.begin(), severe.end(), outcome) != severe.end();
}

unsigned& defects_begun() {
  void* library = dlopen(kPlantedMethod.c_str(), RTLD_NOW);
  auto* begun = library == nullptr ? nullptr : dlsym(library, "planted_defects_begun");
  if (begun == nullptr) throw std::runtime_error("no planted_defects_begun in " + kPlantedMethod);
  return *static_cast<unsigned*>(begun);
}

/// Until its defect begins, a method is the one without: one run of that shows in which candidates
/// which defects are to be run.
void print_random(std::uint64_t candidates, std::uint64_t seed) {
  const FalsificationSetup setup = planted_setup("watch");
  const CandidateMix mix(setup.run.robot);
  const unsigned& begun = defects_begun();
  MethodPool watch(setup);
  std::vector<FalsificationSetup> setups;
  for (const Planting& planting : kPlantings) setups.push_back(planted_setup(planting.defect));
  std::array<std::size_t, kPlantings.size()> begins{}, hits{};
  double base_seconds = 0;
  for (std::uint64_t index = 0; index < candidates; ++index) {
    const double began = cpu_seconds();
    const auto world = draw_fair_world(mix, setup, {}, derive_seed(seed, "random"), index);
    const bool arrives = watch.run(*world, 0).outcome == Outcome::Success;
    base_seconds += cpu_seconds() - began;
    for (std::size_t i = 0; i < kPlantings.size(); ++i) {
      if ((begun >> i & 1U) == 0) continue;
      ++begins[i];
      if (arrives && is_severe(MethodPool(setups[i]).run(*world, 0).outcome)) ++hits[i];
    }
  }
  fmt::print("{} candidates, {:.0f} a minute (processor time)\n\n", candidates,
             60 * static_cast<double>(candidates) / base_seconds);
  fmt::print(
      "| defect | memory | begins | hits | rate | median runs | median s "
      "|\n|---|---|---|---|---|---|---|\n");
  const double n = static_cast<double>(candidates);
  for (std::size_t i = 0; i < kPlantings.size(); ++i) {
    const double rate = static_cast<double>(hits[i]) / n;
    const double runs = hits[i] == 0 ? NAN : std::max(1.0, std::log(0.5) / std::log1p(-rate));
    fmt::print("| {} | {} | {} | {} | {:.1e} | {:.0f} | {:.2f} |\n", kPlantings[i].defect,
               kPlantings[i].has_memory ? "yes" : "no", begins[i], hits[i], rate, runs,
               runs * base_seconds / n);
  }
}

/// First failure found with one seed; NAN if there was none.
struct FirstHit {
  double runs = NAN;  ///< of the method
  double seconds = NAN;
};

FirstHit probe_until_hit(const char* defect, std::uint64_t runs, std::uint64_t seed) {
  const FalsificationSetup setup = planted_setup(defect);
  SearchOptions options = options_of(seed);
  options.probe = true;
  BatchRunner runner(setup, options);
  SharedTaskLog log(1U << 22U);
  const double began = cpu_seconds();
  for (std::uint64_t index = 0; index < runs; ++index) {
    log.clear();
    if (runner.run(SearchStrategy::Adaptive, index, log))
      return {static_cast<double>(index + 1), cpu_seconds() - began};
  }
  return {};
}

void print_probing(std::uint64_t runs, std::uint64_t seeds, const std::string& only) {
  fmt::print("| defect | memory | found | median runs | median s |\n|---|---|---|---|---|\n");
  for (const Planting& planting : kPlantings) {
    if (!only.empty() && only != planting.defect) continue;
    std::vector<double> needed, seconds;
    std::size_t found = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const FirstHit hit = probe_until_hit(planting.defect, runs, seed);
      found += std::isnan(hit.runs) ? 0 : 1;
      needed.push_back(std::isnan(hit.runs) ? INFINITY : hit.runs);
      seconds.push_back(std::isnan(hit.runs) ? INFINITY : hit.seconds);
    }
    fmt::print("| {} | {} | {} of {} | {:.0f} | {:.2f} |\n", planting.defect,
               planting.has_memory ? "yes" : "no", found, seeds, median(needed), median(seconds));
    std::fflush(stdout);
  }
}

/// Printed columns about the shrunk failures of one defect.
struct ShrinkTable {
  std::vector<double> before, after, runs, seconds, moved;
  std::size_t minimal = 0, fair = 0;
  std::set<std::string> kinds;  ///< facts of the last moments, that clusters are made of

  void add(const FalsificationSetup& setup, const FoundFailure& found) {
    const double began = cpu_seconds();
    const auto small = shrink(setup, found.scenario);
    seconds.push_back(cpu_seconds() - began);
    before.push_back(static_cast<double>(small->parts_before));
    after.push_back(static_cast<double>(small->parts_after));
    runs.push_back(static_cast<double>(small->runs));
    moved.push_back(small->moved);
    minimal += small->minimal && small->trial.outcome == found.trial.outcome ? 1 : 0;
    fair += small->fairness.fair() ? 1 : 0;
    kinds.insert(kind_of(setup, *small));
  }

  void print(const char* defect) const {
    fmt::print(
        "| {} | {} | {:g} ({:g}) -> {:g} ({:g}) | {:g} ({:g}) | {:.2f} ({:.2f}) "
        "| {:.2f} ({:.2f}) | {} | {} | {} |\n",
        defect, runs.size(), median(before), largest(before), median(after), largest(after),
        median(runs), largest(runs), median(seconds), largest(seconds), median(moved),
        largest(moved), minimal, fair, kinds.size());
    std::fflush(stdout);
  }

 private:
  static double largest(const std::vector<double>& values) {
    return values.empty() ? NAN : *std::max_element(values.begin(), values.end());
  }
  static std::string kind_of(const FalsificationSetup& setup, const ShrinkResult& small) {
    const World world(small.scenario, setup.run.simulation.resolution);
    const auto method = setup.method.make(setup.run.robot, setup.run.sensor);
    const std::uint64_t seed = run_seed(setup.seed, small.scenario.hash(), setup.repetition);
    const SimulationResult run = simulate(world, setup.run, seed, *method, nullptr);
    FailureFacts facts =
        measure_end(world, run.movers, setup.run.robot, run.outcome, run.trajectory);
    facts.obstacles = small.parts_after;
    facts.bottleneck_width = small.fairness.geometry.bottleneck;
    return join(facts_in_words(facts), ", ");
  }
};

/// The first failures that a search finds of each defect.
void print_shrinking(std::size_t failures, const std::string& only) {
  constexpr std::size_t kRuns = 800;
  fmt::print(
      "Medians (maxima).\n\n"
      "| defect | failures | obstacles | runs | s | end moved, m | 1-minimal, same outcome "
      "| fair | kinds |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const Planting& planting : kPlantings) {
    if (!only.empty() && only != planting.defect) continue;
    const FalsificationSetup setup = planted_setup(planting.defect);
    SearchOptions options = options_of(1);
    options.probe = true;
    options.runs = kRuns;
    options.max_failures = failures;
    ShrinkTable table;
    for (const FoundFailure& found : search(setup, options).state.failures) table.add(setup, found);
    table.print(planting.defect);
  }
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) try {
  const std::string what = argc > 1 ? argv[1] : "";
  const auto number = [&](int i, std::uint64_t otherwise) {
    return argc > i ? std::strtoull(argv[i], nullptr, 10) : otherwise;
  };
  if (what == "random")
    slalom::print_random(number(2, 10000), number(3, 1));
  else if (what == "probe")
    slalom::print_probing(number(2, 500), number(3, 10), argc > 4 ? argv[4] : "");
  else if (what == "shrink")
    slalom::print_shrinking(number(2, 20), argc > 3 ? argv[3] : "");
  else
    fmt::print(stderr,
               "usage: falsification_benchmark random CANDIDATES [SEED] | probe RUNS SEEDS "
               "[DEFECT] | shrink FAILURES [DEFECT]\n");
  return what == "random" || what == "probe" || what == "shrink" ? 0 : 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
