// SPDX-License-Identifier: BSD-3-Clause
#include "rank_stability.h"
#include "scenario_means.h"

#include <slalom/analysis/cross_table.h>
#include <slalom/core/random.h>
#include <slalom/statistics/rank_statistics.h>
#include <slalom/statistics/statistics.h>

#include <algorithm>
#include <map>
#include <utility>

namespace slalom {
namespace {

constexpr int kResamples = 1000;

/// The values of a scenario: of each method, in the first result and in the other one.
struct PairedScenario {
  std::vector<double> first, other;
};

/// Values by scenario hash.
using ScenarioValues = std::map<std::string, std::vector<double>>;

/// Values of the scenarios in which all methods have one.
ScenarioValues values_of_methods(const ResultTable& table, const std::vector<std::string>& methods,
                                 const std::string& metric) {
  std::vector<std::vector<std::optional<double>>> means;
  for (const std::string& method : methods)
    means.push_back(
        scenario_means(table, index_of_method(table, method), require_metric(table, metric)));
  ScenarioValues values;
  for (std::size_t scenario = 0; scenario < table.scenario_hashes.size(); ++scenario) {
    std::vector<double> found;
    for (const auto& of_method : means)
      if (of_method[scenario]) found.push_back(*of_method[scenario]);
    if (found.size() == methods.size()) values[table.scenario_hashes[scenario]] = std::move(found);
  }
  return values;
}

PairedScenario totals_of(const std::vector<const PairedScenario*>& scenarios) {
  PairedScenario totals{std::vector<double>(scenarios[0]->first.size(), 0),
                        std::vector<double>(scenarios[0]->other.size(), 0)};
  for (const PairedScenario* scenario : scenarios) {
    for (std::size_t i = 0; i < totals.first.size(); ++i) {
      totals.first[i] += scenario->first[i];
      totals.other[i] += scenario->other[i];
    }
  }
  return totals;
}

std::vector<double> reordered(const std::vector<double>& values,
                              const std::vector<std::size_t>& order) {
  std::vector<double> result;
  for (const std::size_t i : order) result.push_back(values[i]);
  return result;
}

/// Adds what resampled scenarios tell; `totals` are those of all of them.
void resample(const std::vector<PairedScenario>& scenarios, const PairedScenario& totals,
              const AnalysisOptions& options, const std::string& label, RankStability& stability) {
  const auto ranks_first = ascending_order(totals.first),
             ranks_other = ascending_order(totals.other);
  RandomEngine engine(derive_seed(options.seed, label));
  std::vector<double> taus, same_order;
  std::vector<const PairedScenario*> sample(scenarios.size());
  for (int i = 0; i < kResamples; ++i) {
    for (const PairedScenario*& one : sample)
      one = &scenarios[static_cast<std::size_t>(uniform_real(engine, 0, 1) *
                                                static_cast<double>(scenarios.size()))];
    const auto [first, other] = totals_of(sample);
    if (const auto tau = kendall_tau(first, other)) taus.push_back(*tau);
    if (const auto tau = kendall_tau(reordered(first, ranks_first), reordered(other, ranks_other)))
      same_order.push_back(*tau);
  }
  if (!taus.empty()) stability.interval = percentile_interval(std::move(taus), options.confidence);
  stability.ceiling = noise_ceiling(std::move(same_order), options.confidence);
}

}  // namespace

RankStability rank_stability(const ResultTable& first, const ResultTable& other,
                             const std::string& metric, const AnalysisOptions& options,
                             const std::string& label) {
  std::vector<std::string> methods;
  for (const std::string& name : first.methods)
    if (std::find(other.methods.begin(), other.methods.end(), name) != other.methods.end())
      methods.push_back(name);
  RankStability stability;
  if (methods.size() < 2) return stability;
  const ScenarioValues before = values_of_methods(first, methods, metric),
                       after = values_of_methods(other, methods, metric);
  std::vector<PairedScenario> scenarios;
  for (const auto& [hash, values] : before)
    if (const auto partner = after.find(hash); partner != after.end())
      scenarios.push_back({values, partner->second});
  stability.scenarios = scenarios.size();
  if (scenarios.empty()) return stability;
  std::vector<const PairedScenario*> all;
  for (const PairedScenario& scenario : scenarios) all.push_back(&scenario);
  const PairedScenario totals = totals_of(all);
  stability.tau = kendall_tau(totals.first, totals.other);
  if (stability.tau && scenarios.size() > 1) resample(scenarios, totals, options, label, stability);
  return stability;
}

}  // namespace slalom
