// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/friedman.h>
#include <slalom/statistics/rank_statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace slalom {
namespace {

double normal_cdf(double z) {
  return std::erfc(-z / std::sqrt(2.0)) / 2;
}

/// P(range of k standard normal variables <= q) = k int phi(z) (Phi(z) - Phi(z - q))^(k - 1) dz.
double range_probability(double q, std::size_t k) {
  // The trapezoidal rule converges exponentially for integrands that vanish like this at both ends;
  // the tails beyond 9 standard deviations are below 1e-18.
  constexpr double kStep = 0.1, kEnd = 9;
  const double scale = static_cast<double>(k) * kStep / std::sqrt(2 * M_PI);
  double total = 0;
  for (double z = -kEnd; z <= kEnd; z += kStep) {
    const double inside = normal_cdf(z) - normal_cdf(z - q);
    total += math::exp(-z * z / 2) * math::pow(inside, static_cast<double>(k - 1));
  }
  return scale * total;
}

/// Statistics of the rank sums; `ties` is the sum of t^3 - t over all tied groups.
void add_statistics(FriedmanTest& test, const std::vector<double>& rank_sums, double ties) {
  const double n = static_cast<double>(test.scenarios), k = static_cast<double>(rank_sums.size());
  double squares = 0;
  for (const double sum : rank_sums) squares += math::pow(sum - n * (k + 1) / 2, 2);
  const double scale = n * k * (k + 1) - ties / (k - 1);
  if (scale <= 0) return;  // all methods tied in every scenario
  test.chi_squared = 12 * squares / scale;
  test.p = distributions::chi_squared_survival(test.chi_squared, k - 1);
  const double rest = n * (k - 1) - test.chi_squared;
  if (rest <= 1e-12 * n * k) {
    test.iman_davenport_f = std::numeric_limits<double>::infinity();
    test.iman_davenport_p = 0;
    return;
  }
  test.iman_davenport_f = (n - 1) * test.chi_squared / rest;
  test.iman_davenport_p =
      distributions::fisher_f_survival(test.iman_davenport_f, k - 1, (k - 1) * (n - 1));
}

/// Maximal groups of consecutive methods, in order of rank, within the critical difference.
std::vector<std::vector<std::size_t>> maximal_groups(const std::vector<double>& mean_ranks,
                                                     double critical_difference) {
  std::vector<std::size_t> order(mean_ranks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return mean_ranks[a] < mean_ranks[b]; });
  std::vector<std::vector<std::size_t>> groups;
  std::size_t covered = 0;
  for (std::size_t first = 0; first < order.size(); ++first) {
    std::size_t end = first + 1;
    while (end < order.size() &&
           mean_ranks[order[end]] - mean_ranks[order[first]] <= critical_difference) {
      ++end;
    }
    if (end - first < 2 || end <= covered) continue;
    covered = end;
    groups.emplace_back(order.begin() + static_cast<std::ptrdiff_t>(first),
                        order.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return groups;
}

}  // namespace

double studentized_range_quantile(double alpha, std::size_t k) {
  const auto excess = [&](double q) { return range_probability(q, k) - (1 - alpha); };
  return distributions::find_root(excess, 1e-6, 40.0);
}

FriedmanTest friedman_test(const std::vector<std::vector<double>>& values, bool more_is_better,
                           double alpha) {
  FriedmanTest test;
  test.scenarios = values.size();
  const std::size_t k = values.front().size();
  std::vector<double> rank_sums(k, 0.0);
  double ties = 0;
  for (std::vector<double> row : values) {
    for (double& value : row) value = more_is_better ? -value : value;
    const std::vector<double> ranks = midranks(row, tie_tolerance(row));
    for (std::size_t method = 0; method < k; ++method) rank_sums[method] += ranks[method];
    ties += sum_of_tie_terms(ranks);
  }
  const double n = static_cast<double>(values.size()), size = static_cast<double>(k);
  for (const double sum : rank_sums) test.mean_ranks.push_back(sum / n);
  add_statistics(test, rank_sums, ties);
  test.critical_difference = studentized_range_quantile(alpha, k) / std::sqrt(2.0) *
                             std::sqrt(size * (size + 1) / (6 * n));
  test.groups = maximal_groups(test.mean_ranks, test.critical_difference);
  return test;
}

}  // namespace slalom
