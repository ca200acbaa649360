// SPDX-License-Identifier: BSD-3-Clause
#include "square.h"

#include <slalom/statistics/distributions.h>
#include <slalom/statistics/rank_statistics.h>
#include <slalom/statistics/two_samples.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

constexpr std::size_t kMaxExactRuns = 100;

/// The number of subsets of `size` of the integers `ranks`, by their sum.
std::vector<double> subsets_by_sum(const std::vector<std::size_t>& ranks, std::size_t size) {
  const std::size_t largest = std::accumulate(ranks.begin(), ranks.end(), std::size_t{0});
  std::vector<std::vector<double>> counts(size + 1, std::vector<double>(largest + 1, 0.0));
  counts[0][0] = 1;
  std::size_t reached = 0;
  for (const std::size_t rank : ranks) {
    for (std::size_t chosen = size; chosen > 0; --chosen)
      for (std::size_t sum = 0; sum <= reached; ++sum)
        counts[chosen][sum + rank] += counts[chosen - 1][sum];
    reached += rank;
  }
  return counts[size];
}

/// Midranks are multiples of one half, so their sums are doubled to integers.
double exact_p(const std::vector<double>& ranks, std::size_t size, double rank_sum) {
  std::vector<std::size_t> doubled;
  for (const double rank : ranks)
    doubled.push_back(static_cast<std::size_t>(std::lround(2 * rank)));
  const std::vector<double> counts = subsets_by_sum(doubled, size);
  const auto observed = static_cast<std::size_t>(std::lround(2 * rank_sum));
  double below = 0, above = 0, all = 0;
  for (std::size_t sum = 0; sum < counts.size(); ++sum) {
    if (sum <= observed) below += counts[sum];
    if (sum >= observed) above += counts[sum];
    all += counts[sum];
  }
  return std::min(1.0, 2 * std::min(below, above) / all);
}

double normal_p(const std::vector<double>& ranks, double m, double n, double statistic) {
  const double size = m + n;
  const double variance = m * n / 12 * (size + 1 - sum_of_tie_terms(ranks) / (size * (size - 1)));
  if (variance <= 0) return 1;
  const double distance = std::max(0.0, std::abs(statistic - m * n / 2) - 0.5);
  return 2 * distributions::normal_survival(distance / std::sqrt(variance));
}

}  // namespace

double fisher_exact(std::size_t successes_a, std::size_t n_a, std::size_t successes_b,
                    std::size_t n_b) {
  constexpr double kTolerance = 1e-7;
  const std::size_t successes = successes_a + successes_b;
  const std::size_t low = successes > n_b ? successes - n_b : 0;
  const std::size_t high = std::min(successes, n_a);
  // Weights of the tables with k successes of a, relative to one near the most probable.
  std::vector<double> weights(high - low + 1, 1.0);
  const double share = static_cast<double>(n_a + 1) / static_cast<double>(n_a + n_b + 2);
  const auto mode =
      std::clamp(static_cast<std::size_t>(share * static_cast<double>(successes + 1)), low, high);
  const auto ratio = [&](std::size_t k) {  // of the weights of k + 1 and k
    const double failures_b = static_cast<double>(n_b + k) - static_cast<double>(successes);
    return static_cast<double>(successes - k) * static_cast<double>(n_a - k) /
           (static_cast<double>(k + 1) * (failures_b + 1));
  };
  for (std::size_t k = mode; k < high; ++k) weights[k + 1 - low] = weights[k - low] * ratio(k);
  for (std::size_t k = mode; k > low; --k) weights[k - 1 - low] = weights[k - low] / ratio(k - 1);
  const double limit = weights[successes_a - low] * (1 + kTolerance);
  double all = 0, unlikely = 0;
  for (const double weight : weights) {
    all += weight;
    if (weight <= limit) unlikely += weight;
  }
  return std::min(1.0, unlikely / all);
}

RankSumTest rank_sum_test(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> all = a;
  all.insert(all.end(), b.begin(), b.end());
  const std::vector<double> ranks = midranks(all, tie_tolerance(all));
  const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
  const double rank_sum =
      std::accumulate(ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(a.size()), 0.0);
  RankSumTest test;
  test.statistic = rank_sum - m * (m + 1) / 2;
  test.exact = all.size() <= kMaxExactRuns;
  test.p = test.exact ? exact_p(ranks, a.size(), rank_sum) : normal_p(ranks, m, n, test.statistic);
  return test;
}

Shift rank_sum_shift(const std::vector<double>& a, const std::vector<double>& b,
                     double confidence) {
  std::vector<double> differences;
  for (const double x : a)
    for (const double y : b) differences.push_back(x - y);
  std::sort(differences.begin(), differences.end());
  const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
  const double k = std::floor(m * n / 2 - distributions::normal_quantile(0.5 + confidence / 2) *
                                              std::sqrt(m * n * (m + n + 1) / 12));
  Shift shift;
  shift.estimate = median(differences);
  if (k < 1) return shift;
  const auto rank = static_cast<std::ptrdiff_t>(k);
  shift.interval = Interval{differences.begin()[rank - 1], differences.end()[-rank]};
  return shift;
}

std::optional<Interval> welch_interval(const std::vector<double>& a, const std::vector<double>& b,
                                       double confidence) {
  if (a.size() < 2 || b.size() < 2) return std::nullopt;
  const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
  const double va = square(*standard_deviation(a)) / m, vb = square(*standard_deviation(b)) / n;
  if (va + vb <= 0) return std::nullopt;
  const double difference = mean(a) - mean(b);
  const double freedom = square(va + vb) / (square(va) / (m - 1) + square(vb) / (n - 1));
  const double half =
      distributions::students_t_quantile(0.5 + confidence / 2, freedom) * std::sqrt(va + vb);
  return Interval{difference - half, difference + half};
}

std::size_t min_per_sample(double alpha) {
  std::size_t n = 1;
  for (double p = 1; p > alpha && n < 100; ++n)
    p *= static_cast<double>(n + 1) / (2 * static_cast<double>(2 * n + 1));
  return n;
}

}  // namespace slalom
