// SPDX-License-Identifier: BSD-3-Clause
#include "kept_failures.h"

#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/falsification/diversity.h>

#include <algorithm>
#include <iostream>
#include <map>

namespace slalom {
namespace {

ShrinkResult shrink_once(const FoundFailure& found, const TestBench& bench,
                         const FalsifyArguments& arguments, ShrunkFile& shrunk) {
  if (const ShrinkResult* known = shrunk.find(found)) return *known;
  auto small = shrink(bench, found.scenario,
                      {arguments.fairness, arguments.max_runs, InterruptGuard::raised});
  if (!small) throw Interrupted("the same command continues");
  shrunk.save(found, *small);
  return std::move(*small);
}

/// Obstacles of what is kept, by outcome.
class DistinctAreas {
 public:
  explicit DistinctAreas(double resolution) : resolution_(resolution) {}
  bool insert(const ShrinkResult& small) {
    ObstacleArea area(small.scenario, resolution_);
    std::vector<ObstacleArea>& others = by_outcome_[small.trial.outcome];
    if (!is_distinct(area, others)) return false;
    others.push_back(std::move(area));
    return true;
  }
  std::optional<double> diversity() const {
    std::vector<ObstacleArea> all;
    for (const auto& [outcome, areas] : by_outcome_)
      all.insert(all.end(), areas.begin(), areas.end());
    return slalom::diversity(all);
  }

 private:
  double resolution_;
  std::map<Outcome, std::vector<ObstacleArea>> by_outcome_;
};

}  // namespace

KeptFailures shrink_found(const std::vector<FoundFailure>& all, std::size_t count,
                          const TestBench& bench, const FalsifyArguments& arguments,
                          ShrunkFile shrunk) {
  KeptFailures kept;
  DistinctAreas areas(bench.setup.simulation.resolution);
  const auto progress = make_terminal_progress(arguments.campaign.quiet);
  progress->start("Shrinking failures", all.size());
  for (std::size_t i = 0; i < all.size() && kept.failures.size() < count; ++i) {
    const FoundFailure& found = all[i];
    ShrinkResult small = shrink_once(found, bench, arguments, shrunk);
    progress->advance(i + 1);
    const std::string origin =
        to_string(found.half) + " candidate " + std::to_string(found.index) + " of the search";
    if (!small.fairness.fair())
      std::cerr << origin << ": left out, " << join(small.fairness.violations, "; ") << "\n";
    else if (!areas.insert(small))
      ++kept.near_duplicates;
    else
      kept.failures.push_back(
          {origin, found.scenario, std::move(small), {}, true, found.half == SearchHalf::Random});
  }
  progress->finish();
  std::stable_sort(kept.failures.begin(), kept.failures.end(),
                   [](const Failure& a, const Failure& b) { return is_simpler(a.small, b.small); });
  kept.diversity = areas.diversity();
  return kept;
}

}  // namespace slalom
