// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/rank_statistics.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr std::size_t kMaxForExact = 100;
constexpr std::size_t kMaxForAllPairs = 2000;

/// Distribution of the sum of a random subset of `ranks` (integers), each included with probability
/// 1/2.
std::vector<double> distribution_of_sums(const std::vector<std::size_t>& ranks) {
  std::vector<double> p = {1};
  for (const std::size_t rank : ranks) {
    std::vector<double> next(p.size() + rank, 0.0);
    for (std::size_t sum = 0; sum < p.size(); ++sum) {
      next[sum] += p[sum] / 2;
      next[sum + rank] += p[sum] / 2;
    }
    p = std::move(next);
  }
  return p;
}

/// Midranks are multiples of one half, so their sums are doubled to integers.
double exact_p(const std::vector<double>& ranks, double statistic) {
  std::vector<std::size_t> doubled;
  for (const double rank : ranks)
    doubled.push_back(static_cast<std::size_t>(std::lround(2 * rank)));
  const std::vector<double> p = distribution_of_sums(doubled);
  const auto observed = static_cast<std::size_t>(std::lround(2 * statistic));
  double below = 0, above = 0;
  for (std::size_t sum = 0; sum < p.size(); ++sum) {
    if (sum <= observed) below += p[sum];
    if (sum >= observed) above += p[sum];
  }
  return std::min(1.0, 2 * std::min(below, above));
}

double normal_p(const std::vector<double>& ranks, double statistic) {
  const double n = static_cast<double>(ranks.size());
  const double variance = n * (n + 1) * (2 * n + 1) / 24 - sum_of_tie_terms(ranks) / 48;
  const double distance = std::max(0.0, std::abs(statistic - n * (n + 1) / 4) - 0.5);
  return 2 * distributions::normal_survival(distance / std::sqrt(variance));
}

/// The number of pairwise means that are at most `limit`; `sorted` is increasing.
std::size_t means_up_to(const std::vector<double>& sorted, double limit) {
  std::size_t count = 0, j = sorted.size();
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    while (j > i && (sorted[i] + sorted[j - 1]) / 2 > limit) --j;
    if (j <= i) break;
    count += j - i;
  }
  return count;
}

/// The k-th smallest pairwise mean, k from 1. By bisection for many differences, since all pairs
/// would not fit into memory.
double kth_mean(const std::vector<double>& sorted, std::size_t k) {
  const std::size_t n = sorted.size();
  if (n > kMaxForAllPairs) {
    double low = sorted.front(), high = sorted.back();
    for (double middle = (low + high) / 2; low < middle && middle < high;
         middle = (low + high) / 2) {
      (means_up_to(sorted, middle) >= k ? high : low) = middle;
    }
    return means_up_to(sorted, low) >= k ? low : high;
  }
  std::vector<double> means;
  means.reserve(n * (n + 1) / 2);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i; j < n; ++j) means.push_back((sorted[i] + sorted[j]) / 2);
  }
  const auto position = means.begin() + static_cast<std::ptrdiff_t>(k - 1);
  std::nth_element(means.begin(), position, means.end());
  return *position;
}

/// The number of pairwise means outside the interval on each side, plus one; 0 if even the full
/// range of means has too little confidence. The largest k with P(W <= k - 1) <= alpha / 2.
std::size_t rank_of_bound(std::size_t n, double confidence) {
  const double tail = (1 - confidence) / 2;
  const double size = static_cast<double>(n);
  if (n > kMaxForExact) {
    const double z = distributions::normal_quantile(0.5 + confidence / 2);
    return static_cast<std::size_t>(size * (size + 1) / 4 -
                                    z * std::sqrt(size * (size + 1) * (2 * size + 1) / 24));
  }
  std::vector<std::size_t> ranks;
  for (std::size_t rank = 1; rank <= n; ++rank) ranks.push_back(rank);
  const std::vector<double> p = distribution_of_sums(ranks);
  std::size_t k = 0;
  for (double below = p[0]; below <= tail && k + 1 < p.size(); below += p[k]) ++k;
  return k;
}

}  // namespace

SignedRankTest signed_rank_test(const std::vector<double>& differences) {
  return signed_rank_test(differences, tie_tolerance(differences));
}

SignedRankTest signed_rank_test(const std::vector<double>& differences, double tolerance) {
  std::vector<double> sizes, kept;
  for (const double difference : differences) {
    if (std::abs(difference) <= tolerance) continue;
    kept.push_back(difference);
    sizes.push_back(std::abs(difference));
  }
  SignedRankTest test;
  test.n = kept.size();
  test.zeros = differences.size() - kept.size();
  if (kept.empty()) return test;
  const std::vector<double> ranks = midranks(sizes, tolerance);
  for (std::size_t i = 0; i < kept.size(); ++i) test.statistic += kept[i] > 0 ? ranks[i] : 0;
  test.exact = test.n <= kMaxForExact;
  test.p = test.exact ? exact_p(ranks, test.statistic) : normal_p(ranks, test.statistic);
  return test;
}

Shift hodges_lehmann(const std::vector<double>& differences, double confidence) {
  std::vector<double> sorted = differences;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t pairs = sorted.size() * (sorted.size() + 1) / 2;
  Shift shift;
  shift.estimate = kth_mean(sorted, (pairs + 1) / 2);
  if (pairs % 2 == 0) shift.estimate = (shift.estimate + kth_mean(sorted, pairs / 2 + 1)) / 2;
  const std::size_t k = rank_of_bound(sorted.size(), confidence);
  if (k > 0) shift.interval = Interval{kth_mean(sorted, k), kth_mean(sorted, pairs + 1 - k)};
  return shift;
}

}  // namespace slalom
