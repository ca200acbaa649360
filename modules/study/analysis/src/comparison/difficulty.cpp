// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_means.h"

#include <slalom/analysis/difficulty.h>
#include <slalom/core/random.h>
#include <slalom/core/text.h>
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/rank_regression.h>
#include <slalom/statistics/rank_statistics.h>

#include <algorithm>

namespace slalom {
namespace {

/// Outcomes of all methods in the scenarios (indexes into the results) in which all have one.
struct CompleteOutcomes {
  OutcomeMatrix outcomes;
  std::vector<std::size_t> scenarios;
};

CompleteOutcomes complete_outcomes(const ResultTable& table, const ValueColumn& values) {
  std::vector<std::vector<std::optional<double>>> means;
  for (std::uint32_t method = 0; method < table.methods.size(); ++method)
    means.push_back(scenario_means(table, method, values));
  CompleteOutcomes complete;
  for (std::size_t scenario = 0; scenario < table.scenario_hashes.size(); ++scenario) {
    std::vector<bool> row;
    for (const auto& method : means)
      if (method[scenario]) row.push_back(*method[scenario] > 0.5);
    if (row.size() < means.size()) continue;
    complete.outcomes.push_back(std::move(row));
    complete.scenarios.push_back(scenario);
  }
  return complete;
}

std::vector<double> column_of(const OutcomeMatrix& outcomes, std::size_t method) {
  std::vector<double> column;
  for (const auto& row : outcomes) column.push_back(row[method] ? 1 : 0);
  return column;
}

/// The number of methods that solve each scenario.
std::vector<double> solvers_of(const OutcomeMatrix& outcomes) {
  std::vector<double> solvers;
  for (const auto& row : outcomes)
    solvers.push_back(static_cast<double>(std::count(row.begin(), row.end(), true)));
  return solvers;
}

/// Correlation of the part with the rest of the total.
std::optional<double> correlation_with_rest(const std::vector<double>& part,
                                            std::vector<double> total) {
  for (std::size_t i = 0; i < part.size(); ++i) total[i] -= part[i];
  return pearson(part, total);
}

std::vector<MethodAbility> abilities_of(const ResultTable& table, const OutcomeMatrix& outcomes,
                                        const std::vector<std::size_t>& comparable,
                                        const RaschFit& fit, double confidence) {
  std::vector<MethodAbility> methods;
  for (std::size_t i = 0; i < table.methods.size(); ++i) {
    methods.emplace_back();
    methods.back().method = table.methods[i];
    methods.back().success = mean(column_of(outcomes, i));
  }
  const OutcomeMatrix compared = outcomes_of(outcomes, comparable);
  const std::vector<double> solvers = solvers_of(compared);
  const auto residuals = rasch_residuals(compared, fit.abilities);
  const double z = distributions::normal_quantile(1 - test_level(confidence) / 2);
  for (std::size_t i = 0; i < comparable.size(); ++i) {
    MethodAbility& method = methods[comparable[i]];
    const double ability = fit.abilities[i], half = z * fit.standard_errors[i];
    method.ability = ability;
    method.interval = Interval{ability - half, ability + half};
    method.residuals = residuals[i];
    if (comparable.size() > 2)
      method.discrimination = correlation_with_rest(column_of(compared, i), solvers);
  }
  std::stable_sort(methods.begin(), methods.end(),
                   [](const MethodAbility& a, const MethodAbility& b) {
                     return a.ability.has_value() != b.ability.has_value() ? a.ability.has_value()
                            : a.ability                                    ? *a.ability > *b.ability
                                                                           : a.success > b.success;
                   });
  return methods;
}

std::vector<ScenarioDifficulty> difficulties_of(const CompleteOutcomes& complete,
                                                const std::vector<std::size_t>& comparable,
                                                const std::vector<double>& by_solvers) {
  const OutcomeMatrix compared = outcomes_of(complete.outcomes, comparable);
  std::vector<double> totals;
  for (std::size_t i = 0; i < comparable.size(); ++i) {
    const std::vector<double> column = column_of(compared, i);
    totals.push_back(mean(column) * static_cast<double>(column.size()));
  }
  const std::vector<double> solvers = solvers_of(compared);
  std::vector<ScenarioDifficulty> difficulties;
  for (std::size_t row = 0; row < compared.size(); ++row) {
    ScenarioDifficulty& added = difficulties.emplace_back();
    added.scenario = complete.scenarios[row];
    added.solved_by = static_cast<std::size_t>(solvers[row]);
    added.difficulty = by_solvers[added.solved_by];
    added.discrimination = correlation_with_rest(
        std::vector<double>(compared[row].begin(), compared[row].end()), totals);
  }
  return difficulties;
}

/// The indexes of the families of the scenarios.
std::vector<std::size_t> families_of(const ResultTable& table,
                                     const std::vector<ScenarioDifficulty>& scenarios) {
  std::vector<std::string> names;
  NameIndex index(names);
  std::vector<std::size_t> families;
  for (const ScenarioDifficulty& scenario : scenarios)
    families.push_back(index.index_of(family_in_name(table.scenario_names[scenario.scenario])));
  return families;
}

/// The values of the usable descriptors in the scenarios; notes both kinds in `fit`.
Predictors values_of_descriptors(const ResultTable& table,
                                 const std::vector<ScenarioDifficulty>& scenarios,
                                 GeometryFit& fit) {
  Predictors values;
  for (const ValueColumn& descriptor : table.descriptors) {
    std::vector<double> column;
    for (const ScenarioDifficulty& scenario : scenarios)
      if (!descriptor.is_na(scenario.scenario))
        column.push_back(descriptor.number(scenario.scenario));
    const bool is_complete = column.size() == scenarios.size();
    if (!is_complete) fit.without_value.push_back(descriptor.info().id);
    const auto [low, high] = std::minmax_element(column.begin(), column.end());
    if (!is_complete || *high - *low <= tie_tolerance(column)) continue;
    fit.descriptors.push_back(descriptor.info().id);
    values.push_back(std::move(column));
  }
  return values;
}

/// Fits the difficulty to the geometry and adds the predictions to the scenarios.
std::optional<GeometryFit> fit_geometry(const ResultTable& table,
                                        std::vector<ScenarioDifficulty>& scenarios,
                                        std::uint64_t seed) {
  if (scenarios.size() < kMinScenariosOfGeometry) return std::nullopt;
  GeometryFit fit;
  const Predictors values = values_of_descriptors(table, scenarios, fit);
  if (values.empty()) return std::nullopt;
  std::vector<double> target;
  std::vector<std::size_t> folds;
  RandomEngine engine(derive_seed(seed, "folds of the difficulty"));
  for (const ScenarioDifficulty& scenario : scenarios) {
    target.push_back(scenario.difficulty);
    folds.push_back(
        static_cast<std::size_t>(uniform_int(engine, 0, static_cast<int>(kFoldsOfGeometry) - 1)));
  }
  const auto r2 = [&target](const Predictors& predictors, const std::vector<std::size_t>& parts) {
    return predicted_fraction(target, cross_predict(predictors, target, parts));
  };
  const Predictors all = rank_predictors(values);
  const std::vector<double> predictions = cross_predict(all, target, folds);
  for (std::size_t i = 0; i < scenarios.size(); ++i) scenarios[i].predicted = predictions[i];
  fit.descriptors_r2 = predicted_fraction(target, predictions);
  const std::vector<std::size_t> families = families_of(table, scenarios);
  fit.families = *std::max_element(families.begin(), families.end()) + 1;
  // Names of single scenarios, as of imported ones, are no families.
  if (fit.families > 1 && fit.families <= scenarios.size() / 5) {
    fit.held_out_r2 = r2(all, families);
    fit.family_r2 = r2(group_predictors(families), folds);
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const auto one = r2(rank_predictors({values[i]}), folds))
      fit.leading.emplace_back(fit.descriptors[i], *one);
  std::stable_sort(fit.leading.begin(), fit.leading.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return fit;
}

void require_rate(const ResultTable& table, const std::string& metric) {
  if (resolve_columns(table, {metric})[0].info.is_rate()) return;
  throw usage_error("difficulty", "'" + metric + "' is not a rate",
                    "a metric of 0 or 1, such as success");
}

}  // namespace

std::string family_in_name(const std::string& name) {
  const std::size_t end = name.find_last_not_of("0123456789");
  const bool is_numbered = end != std::string::npos && end > 0 && end + 1 < name.size();
  if (!is_numbered || name[end] != '_') return name;
  return name.substr(0, end);
}

DifficultyScale build_difficulty(const ResultTable& table, const std::string& metric,
                                 const AnalysisOptions& options) {
  require_valid(options);
  require_rate(table, metric);
  if (table.methods.size() > kMaxRaschMethods) {
    throw usage_error("difficulty", count_text(table.methods.size(), "method"),
                      "at most " + std::to_string(kMaxRaschMethods));
  }
  const CompleteOutcomes complete = complete_outcomes(table, require_metric(table, metric));
  const std::vector<std::size_t> comparable = comparable_methods(complete.outcomes);
  if (comparable.size() < 2) {
    throw usage_error("difficulty", "no two methods each solve a scenario that the other one fails",
                      "more methods or scenarios");
  }
  const OutcomeMatrix compared = outcomes_of(complete.outcomes, comparable);
  const RaschFit fit = fit_rasch(compared);
  DifficultyScale scale;
  scale.confidence = options.confidence;
  scale.methods = abilities_of(table, complete.outcomes, comparable, fit, options.confidence);
  scale.left_out = table.scenario_hashes.size() - complete.scenarios.size();
  scale.informative = fit.informative;
  scale.by_solvers = difficulties_by_solvers(fit.abilities);
  for (const std::size_t method : comparable) scale.compared.push_back(table.methods[method]);
  scale.dimensions =
      dimension_test(compared, derive_seed(options.seed, "dimensions of difficulty"));
  scale.andersen = andersen_test(compared);
  scale.scenarios = difficulties_of(complete, comparable, scale.by_solvers);
  scale.geometry = fit_geometry(table, scale.scenarios, options.seed);
  return scale;
}

}  // namespace slalom
