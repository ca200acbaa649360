// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/statistics/dimensionality.h>
#include <slalom/statistics/rasch.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// A method on the scale.
struct MethodAbility {
  std::string method;
  double success = 0;             ///< fraction of the scenarios that it solves
  std::optional<double> ability;  ///< logit; none if it has no finite estimate
  std::optional<Interval> interval;
  std::optional<RaschResiduals> residuals;
  /// Correlation of its outcomes with the number of other methods that solve the scenario.
  /// Negative: it solves rather the scenarios that others fail. None with two methods: the wins of
  /// one are the failures of the other one.
  std::optional<double> discrimination;
};

/// A scenario on the scale.
struct ScenarioDifficulty {
  std::size_t scenario = 0;         ///< index into the results
  std::size_t solved_by = 0;        ///< number of methods with an ability that solve it
  double difficulty = 0;            ///< logit
  std::optional<double> predicted;  ///< from its descriptors, by scenarios of other folds
  /// Correlation, over the methods, of its outcomes with their success in the others. Negative:
  /// weak methods rather than strong ones solve it.
  std::optional<double> discrimination;
};

/// How well the difficulty is predicted without any run: R^2 by cross-validation.
struct GeometryFit {
  std::vector<std::string> descriptors;    ///< used: those that vary and have all values
  std::vector<std::string> without_value;  ///< not used: those without a value in some scenario
  std::size_t families = 0;                ///< of scenarios, by their names
  std::optional<double> descriptors_r2;    ///< 10 folds
  std::optional<double> held_out_r2;       ///< a fold is a family: predicted by the other families
  std::optional<double> family_r2;         ///< 10 folds, by the family alone
  std::vector<std::pair<std::string, double>> leading;  ///< R^2 of one descriptor, largest first
};

constexpr std::size_t kMinScenariosOfGeometry = 50;
constexpr std::size_t kFoldsOfGeometry = 10;

/// Rasch's scale of the abilities of methods and the difficulties of scenarios.
struct DifficultyScale {
  double confidence = 0.95;
  std::vector<MethodAbility> methods;         ///< most able first, then those without an ability
  std::vector<ScenarioDifficulty> scenarios;  ///< those in which every method has a value
  std::size_t left_out = 0;                   ///< scenarios in which some method has none
  std::size_t informative = 0;                ///< solved by some of the methods, but not by all
  std::vector<double> by_solvers;             ///< difficulty by the number of methods that solve it
  std::vector<std::string> compared;  ///< methods with an ability, in the order of DimensionTest
  std::optional<DimensionTest> dimensions;
  std::optional<AndersenTest> andersen;
  std::optional<GeometryFit> geometry;  ///< none without descriptors, or with few scenarios
};

/// A method solves a scenario if the `metric`, a rate such as success, is above 0.5 on average over
/// its repetitions. Throws Error (Usage) if the metric is unknown or not a rate, if there are more
/// than kMaxRaschMethods methods, or if fewer than two of them are comparable.
DifficultyScale build_difficulty(const ResultTable& table, const std::string& metric,
                                 const AnalysisOptions& options);

/// The family in the name of a scenario: "random" of "random_0012"; a name without a number is one
/// of its own.
std::string family_in_name(const std::string& name);

}  // namespace slalom
