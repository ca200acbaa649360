// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/statistics/friedman.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

/// Times in s of 22 players to round first base by three methods: Hollander and Wolfe, table 7.1
/// (also in R's ?friedman.test).
const std::vector<std::vector<double>> kRoundingTimes = {
    {5.40, 5.50, 5.55}, {5.85, 5.70, 5.75}, {5.20, 5.60, 5.50}, {5.55, 5.50, 5.40},
    {5.90, 5.85, 5.70}, {5.45, 5.55, 5.60}, {5.40, 5.40, 5.35}, {5.45, 5.50, 5.35},
    {5.25, 5.15, 5.00}, {5.85, 5.80, 5.70}, {5.25, 5.20, 5.10}, {5.65, 5.55, 5.45},
    {5.60, 5.35, 5.45}, {5.05, 5.00, 4.95}, {5.50, 5.50, 5.40}, {5.45, 5.55, 5.50},
    {5.55, 5.55, 5.35}, {5.45, 5.50, 5.55}, {5.50, 5.45, 5.25}, {5.65, 5.60, 5.40},
    {5.70, 5.65, 5.55}, {6.30, 6.30, 6.25}};

TEST(Friedman, AgreesWithHollanderAndWolfe) {
  const FriedmanTest test = friedman_test(kRoundingTimes, false, 0.05);
  EXPECT_NEAR(test.chi_squared, 11.1429, 5e-5);
  EXPECT_NEAR(test.p, 0.003805, 5e-7);
  EXPECT_NEAR(test.mean_ranks[0] * 22, 53, 1e-9);
  EXPECT_NEAR(test.mean_ranks[1] * 22, 47, 1e-9);
  EXPECT_NEAR(test.mean_ranks[2] * 22, 32, 1e-9);
}

TEST(Friedman, DecimalValuesThatAreEqualTie) {
  // 0.1 + 0.2 and 0.3 are different doubles.
  const std::vector<std::vector<double>> values(3, {0.1 + 0.2, 0.3, 0.5});
  EXPECT_EQ(friedman_test(values, false, 0.05).mean_ranks, (std::vector<double>{1.5, 1.5, 3}));
}

TEST(Friedman, CriticalDifferenceAgreesWithDemsar2006) {
  // "Statistical comparisons of classifiers over multiple data sets": q of table 5 are these
  // quantiles over sqrt(2); four methods on 14 sets: critical difference 1.25, section 3.2.2.
  const double q05[] = {1.960, 2.343, 2.569, 2.728, 2.850, 2.949, 3.031, 3.102, 3.164};
  const double q10[] = {1.645, 2.052, 2.291, 2.459, 2.589, 2.693, 2.780, 2.855, 2.920};
  for (std::size_t k = 2; k <= 10; ++k) {
    EXPECT_NEAR(studentized_range_quantile(0.05, k) / std::sqrt(2.0), q05[k - 2], 1e-3) << k;
    EXPECT_NEAR(studentized_range_quantile(0.10, k) / std::sqrt(2.0), q10[k - 2], 1e-3) << k;
  }
  const std::vector<std::vector<double>> values(14, {1, 2, 3, 4});
  EXPECT_NEAR(friedman_test(values, true, 0.05).critical_difference, 1.25, 0.005);
}

TEST(Friedman, IsCloseToTheExactDistributionOfThreeMethods) {
  // All 6^4 rankings of three methods in four scenarios: P(chi^2 >= 6.5) = 0.042 (Friedman 1937,
  // table V). The statistic is counted here by brute force through this very function.
  const double orders[6][3] = {{1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}};
  int at_least = 0;
  for (int code = 0; code < 1296; ++code) {
    std::vector<std::vector<double>> values;
    for (int i = 0, rest = code; i < 4; ++i, rest /= 6)
      values.emplace_back(orders[rest % 6], orders[rest % 6] + 3);
    at_least += friedman_test(values, false, 0.05).chi_squared >= 6.5 - 1e-9 ? 1 : 0;
  }
  EXPECT_NEAR(at_least / 1296.0, 0.042, 5e-4);
}

TEST(Friedman, GroupsMethodsWithinTheCriticalDifference) {
  // Ranks 1, 2, 3 and 4 in each of 14 scenarios, critical difference 1.25: bars 1-2, 2-3, 3-4.
  const std::vector<std::vector<double>> values(14, {1, 2, 3, 4});
  const FriedmanTest up = friedman_test(values, true, 0.05);
  EXPECT_EQ(up.groups, (std::vector<std::vector<std::size_t>>{{3, 2}, {2, 1}, {1, 0}}));
  EXPECT_TRUE(std::isinf(up.iman_davenport_f));
  const std::vector<std::vector<double>> two(3, {1, 2, 3, 4});  // critical difference 2.7
  EXPECT_EQ(friedman_test(two, false, 0.05).groups.front().size(), 3u);
}

TEST(Friedman, EqualMethodsHaveNoDifference) {
  const FriedmanTest test = friedman_test({{1, 1}, {2, 2}}, true, 0.05);
  EXPECT_EQ(test.p, 1);
  EXPECT_EQ(test.mean_ranks, (std::vector<double>{1.5, 1.5}));
  EXPECT_EQ(test.groups.size(), 1u);
}

}  // namespace
}  // namespace slalom
