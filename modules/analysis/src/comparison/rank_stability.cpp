// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/rank_stability.h>
#include <slalom/analysis/rank_statistics.h>
#include <slalom/analysis/scenario_means.h>
#include <slalom/analysis/statistics.h>
#include <slalom/core/random.h>

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

std::optional<double> tau_of(const std::vector<const PairedScenario*>& scenarios) {
  std::vector<double> first(scenarios[0]->first.size(), 0), other(first);
  for (const PairedScenario* scenario : scenarios) {
    for (std::size_t i = 0; i < first.size(); ++i) {
      first[i] += scenario->first[i];
      other[i] += scenario->other[i];
    }
  }
  return kendall_tau(first, other);
}

std::optional<Interval> bootstrap_of(const std::vector<PairedScenario>& scenarios,
                                     const AnalysisOptions& options, const std::string& label) {
  RandomEngine engine(derive_seed(options.seed, label));
  std::vector<double> taus;
  std::vector<const PairedScenario*> sample(scenarios.size());
  for (int i = 0; i < kResamples; ++i) {
    for (const PairedScenario*& one : sample)
      one = &scenarios[static_cast<std::size_t>(uniform_real(engine, 0, 1) *
                                                static_cast<double>(scenarios.size()))];
    if (const auto tau = tau_of(sample)) taus.push_back(*tau);
  }
  if (taus.empty()) return std::nullopt;
  return percentile_interval(std::move(taus), options.confidence);
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
  stability.tau = tau_of(all);
  if (stability.tau && scenarios.size() > 1)
    stability.interval = bootstrap_of(scenarios, options, label);
  return stability;
}

}  // namespace slalom
