// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/statistics/rank_statistics.h>
#include <slalom/statistics/two_samples.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace slalom {
namespace {

/// Pascal's rule.
std::uint64_t choose(std::size_t n, std::size_t k) {
  std::vector<std::uint64_t> row = {1};
  for (std::size_t i = 0; i < n; ++i) {
    row.push_back(0);
    for (std::size_t j = row.size() - 1; j > 0; --j) row[j] += row[j - 1];
  }
  return k > n ? 0 : row[k];
}

/// The share of divisions of the successes that are at most as probable, in integers.
double fisher_by_counting(std::size_t a, std::size_t m, std::size_t b, std::size_t n) {
  const std::uint64_t observed = choose(m, a) * choose(n, b);
  std::uint64_t unlikely = 0;
  for (std::size_t k = 0; k <= std::min(m, a + b); ++k) {
    const std::uint64_t ways = choose(m, k) * choose(n, a + b - k);
    unlikely += ways <= observed ? ways : 0;
  }
  return static_cast<double>(unlikely) / static_cast<double>(choose(m + n, a + b));
}

TEST(TwoSamples, FishersTestIsTheShareOfTablesThatAreNotMoreProbable) {
  for (const auto& [m, n] : {std::pair<std::size_t, std::size_t>{15, 15}, {1, 4}, {12, 7}, {9, 20}})
    for (std::size_t a = 0; a <= m; ++a)
      for (std::size_t b = 0; b <= n; ++b)
        EXPECT_NEAR(fisher_exact(a, m, b, n), fisher_by_counting(a, m, b, n), 1e-12)
            << a << "/" << m << " " << b << "/" << n;
  // Fisher's tea: 3 of 4 cups of each kind were recognized (1935; Agresti 1990, table 3.8).
  EXPECT_NEAR(fisher_exact(3, 4, 1, 4), 0.485714, 1e-6);
  // Two of the tables with 14 failures in 30 are this unequal, each in 15 ways; 30 over 14 ways.
  EXPECT_NEAR(fisher_exact(1, 15, 15, 15), 30.0 / static_cast<double>(choose(30, 14)), 1e-18);
  EXPECT_NEAR(fisher_exact(1, 15, 15, 15), 2.062952e-7, 1e-12) << "fisher.test() of R";
}

TEST(TwoSamples, FishersTestOfManyRunsHasNoOverflow) {
  EXPECT_EQ(fisher_exact(0, 20000, 20000, 20000), 0);
  EXPECT_EQ(fisher_exact(20000, 20000, 20000, 20000), 1);
  EXPECT_NEAR(fisher_exact(10000, 20000, 10000, 20000), 1, 1e-9);
}

/// Over all subsets of the places of a's ranks.
double rank_sum_p_by_counting(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> all = a;
  all.insert(all.end(), b.begin(), b.end());
  const std::vector<double> ranks = midranks(all);
  const auto sum_of = [&](unsigned subset) {
    double sum = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) sum += (subset >> i) & 1U ? ranks[i] : 0;
    return sum;
  };
  const double observed = sum_of((1U << a.size()) - 1);
  double below = 0, above = 0, count = 0;
  for (unsigned subset = 0; subset < 1U << all.size(); ++subset) {
    if (static_cast<std::size_t>(__builtin_popcount(subset)) != a.size()) continue;
    ++count;
    below += sum_of(subset) <= observed ? 1 : 0;
    above += sum_of(subset) >= observed ? 1 : 0;
  }
  return std::min(1.0, 2 * std::min(below, above) / count);
}

TEST(TwoSamples, TheRankSumTestCountsAllDivisionsWithTies) {
  const std::vector<std::pair<std::vector<double>, std::vector<double>>> samples = {
      {{1.1, 2.2, 3.3, 4.4}, {2.5, 3.5, 5.5, 6.5, 7.5}},
      {{1, 1, 2, 3}, {2, 3, 3, 5, 5, 5}},
      {{7}, {1, 2, 3}},
      {{2, 2}, {2, 2, 2}}};
  for (const auto& [a, b] : samples) {
    const RankSumTest test = rank_sum_test(a, b);
    EXPECT_TRUE(test.exact);
    EXPECT_NEAR(test.p, rank_sum_p_by_counting(a, b), 1e-12);
    EXPECT_NEAR(test.p, rank_sum_test(b, a).p, 1e-12) << "symmetric";
    EXPECT_NEAR(test.statistic / static_cast<double>(a.size() * b.size()),
                probability_of_superiority(a, b), 1e-12);
  }
}

TEST(TwoSamples, EqualValuesHaveNoDifference) {
  const std::vector<double> many(80, 3.0);
  EXPECT_EQ(rank_sum_test(many, many).p, 1);
  EXPECT_FALSE(welch_interval(many, many, 0.95)) << "no error is shown";
  EXPECT_FALSE(welch_interval({1}, many, 0.95));
}

TEST(TwoSamples, ShiftIsTheMedianOfAllDifferences) {
  // Hollander and Wolfe 1999, 4.3, by hand: 25 differences of 5 and 5 values, k = floor(12.5 - 1.96
  // sqrt(25 * 11 / 12)) = 3.
  const std::vector<double> a = {11, 15, 23, 40, 80}, b = {1, 2, 4, 7, 12};
  std::vector<double> differences;
  for (const double x : a)
    for (const double y : b) differences.push_back(x - y);
  std::sort(differences.begin(), differences.end());
  const Shift shift = rank_sum_shift(a, b, 0.95);
  EXPECT_EQ(shift.estimate, differences[12]);
  EXPECT_EQ(shift.interval->low, differences[2]);
  EXPECT_EQ(shift.interval->high, differences[22]);
  EXPECT_FALSE(rank_sum_shift({1}, {2}, 0.95).interval);
}

TEST(TwoSamples, TheSmallestSizesCanReject) {
  // 2 / 70 for two samples of four, 2 / 20 for three.
  EXPECT_EQ(min_per_sample(0.05), 4u);
  EXPECT_EQ(min_per_sample(0.1), 3u);
  for (const std::size_t n : {3, 4}) {
    const double p = fisher_exact(0, n, n, n);
    EXPECT_EQ(p <= 0.05, n >= min_per_sample(0.05)) << p;
  }
}

}  // namespace
}  // namespace slalom
