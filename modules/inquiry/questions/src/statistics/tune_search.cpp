// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/inquiry/tune_search.h>
#include <slalom/statistics/paired_rates.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <tuple>

namespace slalom {
namespace {

constexpr std::size_t kFullRung = 8, kSmallRung = 4;  ///< scenarios of the first rung
constexpr std::size_t kMinNew = 6;                    ///< new configurations of an iteration
constexpr double kNarrowing[kTuneIterations] = {1, 0.2, 0.12};

/// Budgets below have small first rungs, and finals of fewer than 100 scenarios.
constexpr std::size_t kSmallBudget = 1000;

void require(bool valid, const std::string& key, std::size_t value, std::size_t least) {
  if (!valid)
    throw usage_error("tune_search." + key, std::to_string(value),
                      "at least " + std::to_string(least));
}

class TuneSearch {
 public:
  TuneSearch(const ParameterSpace& space, const TuneOptions& options, const RunConfiguration& run)
      : space_(space),
        options_(options),
        run_(run),
        first_rung_(options.budget < kSmallBudget ? kSmallRung : kFullRung),
        points_(space.size(), derive_seed(options.seed, "sobol")),
        engine_(derive_seed(options.seed, "draws")) {
    require(options.budget >= kMinTuneBudget, "budget", options.budget, kMinTuneBudget);
    require(options.development >= kFullRung, "development", options.development, kFullRung);
    require(options.finals >= 1, "finals", options.finals, 1);
  }

  TuneResult search() {
    add(space_.defaults());
    std::vector<std::size_t> elites = {0};
    bool complete = true;
    for (std::size_t i = 0; complete && i < kTuneIterations; ++i) {
      const std::size_t share = search_budget() * (i + 1) / kTuneIterations;
      const std::vector<std::size_t> alive = add_new(i, elites, share);
      if (i == 0) result_.spread = result_.candidates.size() - 1;
      complete = halve(alive, share, elites);
      if (complete) result_.elites.push_back(elites);
    }
    result_.complete = complete && run_finals(elites);
    if (result_.complete) choose_winner();
    return std::move(result_);
  }

 private:
  std::size_t search_budget() const {
    const std::size_t budget = options_.budget;
    const std::size_t for_finals = 100 * (kTuneElites + 1);
    const std::size_t rest = budget > for_finals ? budget - for_finals : 0;
    return std::max(budget * 2 / 5, std::min(budget * 3 / 5, rest));
  }

  bool add(Configuration configuration) {
    if (!known_.insert(configuration).second) return false;
    result_.candidates.push_back({std::move(configuration), {}, {}});
    return true;
  }

  /// Returns `elites` and new candidates; fewer than wanted if hardly any are left in the space.
  std::vector<std::size_t> add_new(std::size_t iteration, const std::vector<std::size_t>& elites,
                                   std::size_t share) {
    const double rungs = 2.3;  // runs in units of those of the first rung
    const double left = static_cast<double>(share - result_.runs(TunePhase::Development));
    const std::size_t wanted = std::max(
        kMinNew, static_cast<std::size_t>(left / (rungs * static_cast<double>(first_rung_))));
    std::vector<std::size_t> alive = elites;
    for (std::size_t i = 0; i < 20 * wanted && alive.size() < elites.size() + wanted; ++i) {
      const Configuration& elite = result_.candidates[elites[i % elites.size()]].configuration;
      const std::size_t index = result_.candidates.size();
      if (add(iteration == 0 ? space_.from_unit(points_.next())
                             : space_.sample_around(elite, kNarrowing[iteration], engine_)))
        alive.push_back(index);
    }
    return alive;
  }

  /// Successive halving. Returns false when interrupted.
  bool halve(std::vector<std::size_t> alive, std::size_t share, std::vector<std::size_t>& elites) {
    for (std::size_t n = first_rung_;;) {
      for (const std::size_t index : alive)
        if (!run_until(TunePhase::Development, index, n)) return false;
      sort(alive);
      elites.assign(alive.begin(), alive.begin() + static_cast<std::ptrdiff_t>(
                                                       std::min(kTuneElites, alive.size())));
      if (alive.size() <= kTuneElites || n >= options_.development) return true;
      alive.resize(std::max(kTuneElites, (alive.size() + 1) / 2));
      n = std::min(2 * n, options_.development);
      if (result_.runs(TunePhase::Development) + missing(alive, n) > share) return true;
    }
  }

  std::size_t missing(const std::vector<std::size_t>& alive, std::size_t n) const {
    std::size_t count = 0;
    for (const std::size_t index : alive)
      count += n - std::min(n, result_.candidates[index].development.size());
    return count;
  }

  /// Best first.
  void sort(std::vector<std::size_t>& alive) const {
    using Key = std::tuple<double, double, std::size_t>;
    std::vector<Key> keys;
    for (const std::size_t index : alive) {
      const TuneCounts counts = counts_of(result_.candidates[index].development);
      const double cost = static_cast<double>(counts.runs - counts.successes) +
                          (options_.collision_cost - 1) * static_cast<double>(counts.collisions);
      keys.emplace_back(cost / static_cast<double>(counts.runs),
                        counts.secondary.value_or(std::numeric_limits<double>::infinity()), index);
    }
    std::sort(keys.begin(), keys.end());
    std::transform(keys.begin(), keys.end(), alive.begin(),
                   [](const Key& key) { return std::get<2>(key); });
  }

  /// Runs a candidate in those of the first `n` scenarios in which it has not run. Returns false
  /// when interrupted.
  bool run_until(TunePhase phase, std::size_t index, std::size_t n) {
    TuneCandidate& candidate = result_.candidates[index];
    auto& outcomes = phase == TunePhase::Finals ? candidate.finals : candidate.development;
    if (outcomes.size() >= n) return true;
    const std::vector<TuneOutcome> more =
        run_({phase, index, candidate.configuration, outcomes.size(), n - outcomes.size()});
    outcomes.insert(outcomes.end(), more.begin(), more.end());
    return outcomes.size() == n;
  }

  bool run_finals(const std::vector<std::size_t>& elites) {
    result_.finalists = elites;
    if (std::find(elites.begin(), elites.end(), 0) == elites.end()) result_.finalists.push_back(0);
    const std::size_t left = options_.budget - result_.runs(TunePhase::Development);
    const std::size_t n = std::min(options_.finals, left / result_.finalists.size());
    return std::all_of(result_.finalists.begin(), result_.finalists.end(),
                       [&](std::size_t index) { return run_until(TunePhase::Finals, index, n); });
  }

  void choose_winner() {
    const auto collisions = [&](std::size_t index) {
      return counts_of(result_.candidates[index].finals).collisions;
    };
    const auto key = [&](std::size_t index) {
      const TuneCounts counts = counts_of(result_.candidates[index].finals);
      return std::tuple(counts.collisions > collisions(0), counts.runs - counts.successes, index);
    };
    auto& finalists = result_.finalists;
    std::sort(finalists.begin(), finalists.end(),
              [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    std::vector<std::size_t> equal;
    for (const std::size_t index : finalists)
      if (collisions(index) <= collisions(0) && !is_worse(index, finalists[0]))
        equal.push_back(index);
    const std::vector<double> secondary = common_secondary(equal);
    result_.winner = equal[static_cast<std::size_t>(
        std::min_element(secondary.begin(), secondary.end()) - secondary.begin())];
  }

  bool is_worse(std::size_t index, std::size_t best) const {
    return success_p_value(result_.candidates[index].finals, result_.candidates[best].finals) <=
           test_level(options_.confidence);
  }

  /// Sums of the secondary value over the scenarios in which all of `indexes` have one.
  std::vector<double> common_secondary(const std::vector<std::size_t>& indexes) const {
    std::vector<double> sums(indexes.size());
    for (std::size_t i = 0; i < result_.candidates[0].finals.size(); ++i) {
      const auto value = [&](std::size_t index) {
        return result_.candidates[index].finals[i].secondary;
      };
      if (!std::all_of(indexes.begin(), indexes.end(), [&](std::size_t j) { return value(j); }))
        continue;
      for (std::size_t j = 0; j < indexes.size(); ++j) sums[j] += *value(indexes[j]);
    }
    return sums;
  }

  const ParameterSpace& space_;
  const TuneOptions& options_;
  const RunConfiguration& run_;
  std::size_t first_rung_;
  SobolPoints points_;
  RandomEngine engine_;
  std::set<Configuration> known_;
  TuneResult result_;
};

}  // namespace

double TuneCounts::rate() const {
  return runs == 0 ? 0 : static_cast<double>(successes) / static_cast<double>(runs);
}

TuneCounts counts_of(const std::vector<TuneOutcome>& outcomes) {
  TuneCounts counts;
  std::vector<double> secondary;
  for (const TuneOutcome& outcome : outcomes) {
    ++counts.runs;
    counts.successes += outcome.success ? 1 : 0;
    counts.collisions += outcome.collision ? 1 : 0;
    if (outcome.secondary) secondary.push_back(*outcome.secondary);
  }
  if (!secondary.empty()) counts.secondary = mean(secondary);
  return counts;
}

double success_p_value(const std::vector<TuneOutcome>& a, const std::vector<TuneOutcome>& b) {
  std::size_t only_a = 0, only_b = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    only_a += a[i].success && !b[i].success ? 1 : 0;
    only_b += b[i].success && !a[i].success ? 1 : 0;
  }
  return mcnemar_exact(only_a, only_b);
}

std::size_t TuneResult::runs(TunePhase phase) const {
  return std::accumulate(
      candidates.begin(), candidates.end(), std::size_t{0},
      [phase](std::size_t sum, const TuneCandidate& candidate) {
        return sum + (phase == TunePhase::Finals ? candidate.finals : candidate.development).size();
      });
}

TuneResult tune_search(const ParameterSpace& space, const TuneOptions& options,
                       const RunConfiguration& run) {
  return TuneSearch(space, options, run).search();
}

}  // namespace slalom
