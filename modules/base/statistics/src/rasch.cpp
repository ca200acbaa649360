// SPDX-License-Identifier: BSD-3-Clause
#include "cholesky.h"

#include <slalom/core/math.h>
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/rasch.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace slalom {
namespace {

std::size_t solvers(const std::vector<bool>& row) {
  return static_cast<std::size_t>(std::count(row.begin(), row.end(), true));
}

bool is_informative(const std::vector<bool>& row) {
  return solvers(row) > 0 && solvers(row) < row.size();
}

/// The elementary symmetric functions of orders 0 to n of the n values but those of two indexes; an
/// index beyond the last leaves out none. All terms are positive, so that no digits are lost.
std::vector<double> symmetric_functions(const std::vector<double>& values, std::size_t without,
                                        std::size_t also_without) {
  std::vector<double> functions(values.size() + 1, 0.0);
  functions[0] = 1;
  std::size_t used = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i == without || i == also_without) continue;
    ++used;
    for (std::size_t order = used; order > 0; --order)
      functions[order] += values[i] * functions[order - 1];
  }
  return functions;
}

std::vector<double> exponentials(const std::vector<double>& abilities) {
  std::vector<double> values;
  for (const double ability : abilities) values.push_back(math::exp(ability));
  return values;
}

/// The sufficient statistics of the conditional likelihood.
struct Margins {
  std::vector<double> of_methods;  ///< informative scenarios that each method solves
  std::vector<double> of_scores;   ///< informative scenarios by the number of their solvers
};

Margins margins_of(const OutcomeMatrix& outcomes) {
  const std::size_t methods = outcomes.front().size();
  Margins margins{std::vector<double>(methods, 0.0), std::vector<double>(methods + 1, 0.0)};
  for (const auto& row : outcomes) {
    if (!is_informative(row)) continue;
    margins.of_scores[solvers(row)] += 1;
    for (std::size_t i = 0; i < methods; ++i) margins.of_methods[i] += row[i] ? 1 : 0;
  }
  return margins;
}

double log_likelihood(const Margins& margins, const std::vector<double>& abilities) {
  const std::size_t methods = abilities.size();
  const auto all = symmetric_functions(exponentials(abilities), methods, methods);
  double sum = 0;
  for (std::size_t i = 0; i < methods; ++i) sum += margins.of_methods[i] * abilities[i];
  for (std::size_t score = 1; score < methods; ++score)
    sum -= margins.of_scores[score] * math::log(all[score]);
  return sum;
}

/// [method][score]: the probability that the method is among so many that solve a scenario;
/// `values` are the exponentials of the abilities.
SquareMatrix solving_probabilities(const std::vector<double>& values) {
  const std::size_t n = values.size();
  const auto all = symmetric_functions(values, n, n);
  SquareMatrix solves;
  for (std::size_t i = 0; i < n; ++i) {
    const auto others = symmetric_functions(values, i, n);
    solves.emplace_back(n, 0.0);
    for (std::size_t score = 1; score < n; ++score)
      solves[i][score] = values[i] * others[score - 1] / all[score];
  }
  return solves;
}

/// First and second derivatives of the log-likelihood.
struct Derivatives {
  std::vector<double> gradient;
  SquareMatrix information;  ///< singular: the sum of the abilities is free
};

Derivatives derivatives_at(const Margins& margins, const std::vector<double>& abilities) {
  const std::size_t n = abilities.size();
  const std::vector<double> values = exponentials(abilities);
  const auto all = symmetric_functions(values, n, n);
  const SquareMatrix solves = solving_probabilities(values);
  Derivatives result{margins.of_methods, SquareMatrix(n, std::vector<double>(n, 0.0))};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t score = 1; score < n; ++score)
      result.gradient[i] -= margins.of_scores[score] * solves[i][score];
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const auto others = symmetric_functions(values, i, j);
      for (std::size_t score = 1; score < n; ++score) {
        const double both = i == j      ? solves[i][score]
                            : score < 2 ? 0
                                        : values[i] * values[j] * others[score - 2] / all[score];
        result.information[i][j] +=
            margins.of_scores[score] * (both - solves[i][score] * solves[j][score]);
      }
      result.information[j][i] = result.information[i][j];
    }
  }
  return result;
}

/// Adds `weight` in the direction of equal abilities, in which the information is 0.
SquareMatrix regularized(SquareMatrix information, double weight) {
  for (auto& row : information)
    for (double& entry : row) entry += weight;
  return information;
}

/// The mean diagonal element, so that the regularized matrix is well conditioned.
double scale_of(const SquareMatrix& information) {
  double sum = 0;
  for (std::size_t i = 0; i < information.size(); ++i) sum += information[i][i];
  return sum / static_cast<double>(information.size());
}

std::vector<double> standard_errors(const SquareMatrix& information) {
  const std::size_t n = information.size();
  const double weight = scale_of(information);
  const SquareMatrix factor = cholesky(regularized(information, weight));
  const double free = 1 / (weight * static_cast<double>(n) * static_cast<double>(n));
  std::vector<double> errors;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> unit(n, 0.0);
    unit[i] = 1;
    errors.push_back(std::sqrt(std::max(0.0, solve(factor, unit)[i] - free)));
  }
  return errors;
}

/// One step of Newton's method, at most 1 logit and halved until the likelihood does not fall.
/// Returns its largest component.
double improve(const Margins& margins, std::vector<double>& abilities) {
  const Derivatives at = derivatives_at(margins, abilities);
  std::vector<double> step =
      solve(cholesky(regularized(at.information, scale_of(at.information))), at.gradient);
  double largest = 0;
  for (const double part : step) largest = std::max(largest, std::abs(part));
  double scale = 1 / std::max(1.0, largest);
  const double before = log_likelihood(margins, abilities);
  constexpr double kRounding = 1e-12;
  for (int halving = 0; halving < 30; ++halving, scale /= 2) {
    std::vector<double> next = abilities;
    for (std::size_t i = 0; i < next.size(); ++i) next[i] += scale * step[i];
    if (log_likelihood(margins, next) < before - kRounding * std::abs(before)) continue;
    abilities = std::move(next);
    return scale * largest;
  }
  return 0;
}

/// Moments that the model expects in scenarios of one ease, the negative of their difficulty.
struct Expectation {
  double score = 0, information = 0, skewness = 0;
};

Expectation expect(const std::vector<double>& abilities, double ease) {
  Expectation sum;
  for (const double ability : abilities) {
    const double p = 1 / (1 + math::exp(-ability - ease));
    sum.score += p;
    sum.information += p * (1 - p);
    sum.skewness += p * (1 - p) * (1 - 2 * p);
  }
  return sum;
}

/// The ease of scenarios of a score, by bisection: maximum likelihood, which requires an
/// informative score, or Warm's weighted likelihood.
double ease_of(const std::vector<double>& abilities, std::size_t score, bool weighted) {
  double low = -60, high = 60;
  for (int halving = 0; halving < 100; ++halving) {
    const double middle = (low + high) / 2;
    const Expectation at = expect(abilities, middle);
    const double excess =
        static_cast<double>(score) - at.score + (weighted ? at.skewness / (2 * at.information) : 0);
    (excess > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// The strongly connected components of the relation "solves a scenario that the other one fails".
class Components {
 public:
  explicit Components(const OutcomeMatrix& outcomes) {
    const std::size_t n = outcomes.empty() ? 0 : outcomes.front().size();
    reaches_.resize(n, 0);
    for (const auto& row : outcomes) {
      std::uint64_t failed = 0;
      for (std::size_t j = 0; j < n; ++j) failed |= std::uint64_t{!row[j]} << j;
      for (std::size_t i = 0; i < n; ++i) reaches_[i] |= row[i] ? failed : 0;
    }
    for (std::size_t via = 0; via < n; ++via)
      for (std::size_t i = 0; i < n; ++i) reaches_[i] |= reaches(i, via) ? reaches_[via] : 0;
  }

  std::vector<std::size_t> of(std::size_t method) const {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < reaches_.size(); ++i)
      if (i == method || (reaches(i, method) && reaches(method, i))) members.push_back(i);
    return members;
  }

 private:
  std::vector<std::uint64_t> reaches_;  ///< a bit per method

  bool reaches(std::size_t i, std::size_t j) const { return (reaches_[i] >> j & 1) != 0; }
};

}  // namespace

std::vector<std::size_t> comparable_methods(const OutcomeMatrix& outcomes) {
  const Components components(outcomes);
  std::vector<std::size_t> largest;
  for (std::size_t i = 0; !outcomes.empty() && i < outcomes.front().size(); ++i) {
    std::vector<std::size_t> members = components.of(i);
    if (members.size() > largest.size()) largest = std::move(members);
  }
  return largest;
}

OutcomeMatrix outcomes_of(const OutcomeMatrix& outcomes, const std::vector<std::size_t>& methods) {
  OutcomeMatrix part;
  for (const auto& row : outcomes) {
    part.emplace_back();
    for (const std::size_t method : methods) part.back().push_back(row[method]);
  }
  return part;
}

RaschFit fit_rasch(const OutcomeMatrix& outcomes) {
  const Margins margins = margins_of(outcomes);
  const std::size_t methods = outcomes.front().size();
  RaschFit fit;
  fit.abilities.assign(methods, 0.0);
  constexpr int kMaxSteps = 100;
  for (int i = 0; i < kMaxSteps && improve(margins, fit.abilities) > 1e-9; ++i) {
  }
  double sum = 0;
  for (const double ability : fit.abilities) sum += ability;
  for (double& ability : fit.abilities) ability -= sum / static_cast<double>(methods);
  fit.standard_errors = standard_errors(derivatives_at(margins, fit.abilities).information);
  fit.log_likelihood = log_likelihood(margins, fit.abilities);
  for (const double scenarios : margins.of_scores)
    fit.informative += static_cast<std::size_t>(scenarios);
  return fit;
}

double conditional_log_likelihood(const OutcomeMatrix& outcomes,
                                  const std::vector<double>& abilities) {
  return log_likelihood(margins_of(outcomes), abilities);
}

std::optional<AndersenTest> andersen_test(const OutcomeMatrix& outcomes) {
  std::vector<std::size_t> scores;
  for (const auto& row : outcomes) scores.push_back(solvers(row));
  std::sort(scores.begin(), scores.end());
  const std::size_t twice_median =
      scores.empty() ? 0 : scores[(scores.size() - 1) / 2] + scores[scores.size() / 2];
  OutcomeMatrix easy, hard;
  for (const auto& row : outcomes) (2 * solvers(row) > twice_median ? easy : hard).push_back(row);

  AndersenTest test;
  for (std::size_t i = 0; !outcomes.empty() && i < outcomes.front().size(); ++i)
    test.methods.push_back(i);
  // Leaving out a method may part the others in the other group.
  for (std::size_t before = 0; before != test.methods.size();) {
    before = test.methods.size();
    for (const OutcomeMatrix* group : {&easy, &hard}) {
      std::vector<std::size_t> left;
      for (const std::size_t i : comparable_methods(outcomes_of(*group, test.methods)))
        left.push_back(test.methods[i]);
      test.methods = std::move(left);
    }
  }
  if (test.methods.size() < 2) return std::nullopt;
  const auto maximum = [&test](const OutcomeMatrix& group) {
    return fit_rasch(outcomes_of(group, test.methods)).log_likelihood;
  };
  test.statistic = std::max(0.0, 2 * (maximum(easy) + maximum(hard) - maximum(outcomes)));
  test.degrees = test.methods.size() - 1;
  test.p = distributions::chi_squared_survival(test.statistic, static_cast<double>(test.degrees));
  return test;
}

std::vector<double> difficulties_by_solvers(const std::vector<double>& abilities) {
  std::vector<double> difficulties;
  for (std::size_t score = 0; score <= abilities.size(); ++score)
    difficulties.push_back(-ease_of(abilities, score, true));
  return difficulties;
}

std::vector<RaschResiduals> rasch_residuals(const OutcomeMatrix& outcomes,
                                            const std::vector<double>& abilities) {
  const std::size_t methods = abilities.size();
  const Margins margins = margins_of(outcomes);
  std::vector<std::vector<double>> wins(methods, std::vector<double>(methods, 0.0));
  for (const auto& row : outcomes) {
    if (!is_informative(row)) continue;
    for (std::size_t i = 0; i < methods; ++i) wins[i][solvers(row)] += row[i] ? 1 : 0;
  }
  const SquareMatrix solves = solving_probabilities(exponentials(abilities));
  std::vector<RaschResiduals> residuals(methods, RaschResiduals{0, 0, 0, 0});
  std::vector<double> variances(methods, 0.0);
  double scenarios = 0;
  for (std::size_t score = 1; score < methods; ++score) {
    const double n = margins.of_scores[score], ease = ease_of(abilities, score, false);
    scenarios += n;
    for (std::size_t i = 0; i < methods; ++i) {
      const double p = 1 / (1 + math::exp(-abilities[i] - ease)), variance = p * (1 - p);
      const auto squares = [&](double solved) {
        return solved * (1 - p) * (1 - p) + (n - solved) * p * p;
      };
      variances[i] += n * variance;
      residuals[i].infit += squares(wins[i][score]);
      residuals[i].outfit += squares(wins[i][score]) / variance;
      residuals[i].expected_infit += squares(n * solves[i][score]);
      residuals[i].expected_outfit += squares(n * solves[i][score]) / variance;
    }
  }
  for (std::size_t i = 0; i < methods; ++i) {
    residuals[i].infit /= variances[i];
    residuals[i].outfit /= scenarios;
    residuals[i].expected_infit /= variances[i];
    residuals[i].expected_outfit /= scenarios;
  }
  return residuals;
}

}  // namespace slalom
