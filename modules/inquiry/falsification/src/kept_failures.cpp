// SPDX-License-Identifier: BSD-3-Clause
#include "diversity.h"

#include <slalom/core/text.h>
#include <slalom/falsification/kept_failures.h>

#include <algorithm>
#include <map>

namespace slalom {
namespace {

std::optional<ShrinkResult> shrink_once(const FoundFailure& found, const FalsificationSetup& setup,
                                        const KeepOptions& options) {
  if (options.known != nullptr)
    if (const ShrinkResult* known = options.known->find(found)) return *known;
  auto small = shrink(setup, found.scenario, options.shrink);
  if (small && options.known != nullptr) options.known->save(found, *small);
  return small;
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

std::optional<KeptFailures> shrink_found(const std::vector<FoundFailure>& all,
                                         const FalsificationSetup& setup,
                                         const KeepOptions& options, Progress& progress) {
  KeptFailures kept;
  DistinctAreas areas(setup.run.simulation.resolution);
  progress.start("Shrinking failures", all.size());
  for (std::size_t i = 0; i < all.size() && kept.failures.size() < options.count; ++i) {
    const FoundFailure& found = all[i];
    auto small = shrink_once(found, setup, options);
    if (!small) return std::nullopt;
    progress.advance(i + 1);
    const std::string origin =
        to_string(found.strategy) + " candidate " + std::to_string(found.index) + " of the search";
    if (!small->fairness.fair()) {
      if (options.notify)
        options.notify(origin + ": left out, " + join(small->fairness.violations, "; "));
    } else if (!areas.insert(*small)) {
      ++kept.near_duplicates;
    } else {
      kept.failures.push_back({origin,
                               found.scenario,
                               std::move(*small),
                               {},
                               true,
                               found.strategy == SearchStrategy::Random});
    }
  }
  progress.finish();
  std::stable_sort(kept.failures.begin(), kept.failures.end(),
                   [](const Failure& a, const Failure& b) { return is_simpler(a.small, b.small); });
  kept.diversity = areas.diversity();
  return kept;
}

}  // namespace slalom
