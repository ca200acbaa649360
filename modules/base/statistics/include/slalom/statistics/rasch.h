// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// Whether each method solves each scenario: outcomes[scenario][method].
using OutcomeMatrix = std::vector<std::vector<bool>>;

constexpr std::size_t kMaxRaschMethods = 64;

/// Rasch's model (1960): a method of ability a solves a scenario of difficulty d with probability
/// 1 / (1 + exp(d - a)). Methods are the items and scenarios the persons, so that the abilities are
/// consistent in the number of scenarios whatever the distribution of their difficulties.
struct RaschFit {
  std::vector<double> abilities;        ///< logit, by method; their sum is 0
  std::vector<double> standard_errors;  ///< logit, of the abilities
  double log_likelihood = 0;            ///< conditional
  std::size_t informative = 0;          ///< scenarios that some methods solve, but not all
};

/// The largest set of methods (indexes) whose abilities have finite estimates: each is linked to
/// each other by scenarios that one solves and the next one fails (Fischer 1981, Psychometrika
/// 46:59-77). A method that solves all scenarios, or none, is not in it. At most kMaxRaschMethods
/// methods.
std::vector<std::size_t> comparable_methods(const OutcomeMatrix& outcomes);

/// The columns of these methods.
OutcomeMatrix outcomes_of(const OutcomeMatrix& outcomes, const std::vector<std::size_t>& methods);

/// Conditional maximum likelihood (Andersen 1972) given the number of methods that solve each
/// scenario, by Newton's method; standard errors from the information. Requires at least two
/// methods, all of them comparable.
RaschFit fit_rasch(const OutcomeMatrix& outcomes);

/// The log-likelihood that fit_rasch() maximizes: the probabilities of the rows given their sums,
/// in which the difficulties cancel.
double conditional_log_likelihood(const OutcomeMatrix& outcomes,
                                  const std::vector<double>& abilities);

/// Andersen's (1973) likelihood ratio test of whether the abilities are the same in easy scenarios,
/// which more than the median number of methods solve, and in the others. It hardly detects groups
/// of methods with different dimensions of difficulty: DimensionTest.
struct AndersenTest {
  double statistic = 0;
  std::size_t degrees = 0;           ///< of freedom of the chi-squared distribution
  double p = 1;                      ///< small: the abilities differ
  std::vector<std::size_t> methods;  ///< those that are comparable in both groups
};

/// None if fewer than two methods are comparable in both groups.
std::optional<AndersenTest> andersen_test(const OutcomeMatrix& outcomes);

/// The difficulty (logit) of scenarios that 0, 1, ..., all of the methods solve, by Warm's (1989)
/// weighted likelihood, which is finite for all.
std::vector<double> difficulties_by_solvers(const std::vector<double>& abilities);

/// Mean squares of the residuals of a method over the informative scenarios (Wright and Masters
/// 1982). Above their expectations, the method's outcomes are less predictable than the model says.
struct RaschResiduals {
  double outfit = 1;  ///< of standardized residuals: sensitive to single surprising scenarios
  double infit = 1;   ///< weighted by the information
  /// Expectations under the model with these abilities, given how many methods solve each
  /// scenario: exact, without the difficulties. They tend to 1 with the number of methods and are
  /// below it for few, since the same outcomes determine the difficulties.
  double expected_outfit = 1, expected_infit = 1;
};

/// Returns those of each method, with the difficulties of maximum likelihood. Requires an
/// informative scenario.
std::vector<RaschResiduals> rasch_residuals(const OutcomeMatrix& outcomes,
                                            const std::vector<double>& abilities);

}  // namespace slalom
