// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/power.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

TEST(Power, RequiredPairsAgreeWithTheTableOfGPower) {
  // Faul et al. 2007, matched pairs, two-sided 5 %, 80 %: effect sizes 0.5, 0.2, 0.8 (small, medium
  // and large of Cohen 1988) take 34, 199 and 15 pairs.
  EXPECT_EQ(required_pairs(0.5, 1, 0.05, 0.8), 34u);
  EXPECT_EQ(required_pairs(0.2, 1, 0.05, 0.8), 199u);
  EXPECT_EQ(required_pairs(0.8, 1, 0.05, 0.8), 15u);
  EXPECT_EQ(required_pairs(0.05, 0.1, 0.05, 0.8), 34u);  // only the ratio counts
}

TEST(Power, PairsNeededAgreeWithRForManyPairs) {
  // power.t.test(delta = d, sd = 1, type = "paired", strict = TRUE)$n of R 4: 786.8089 at 0.1,
  // 3141.465 at 0.05, 19624.07 at 0.02, 313956.3 at 0.005; whole pairs are needed.
  EXPECT_EQ(required_pairs(0.1, 1, 0.05, 0.8), 787u);
  EXPECT_EQ(required_pairs(0.05, 1, 0.05, 0.8), 3142u);
  EXPECT_EQ(required_pairs(0.02, 1, 0.05, 0.8), 19625u);
  EXPECT_EQ(required_pairs(0.005, 1, 0.05, 0.8), 313957u);
}

TEST(Power, IsTheRejectionRateOfTheTest) {
  RandomEngine engine(1);
  const int trials = 4000, n = 12;
  int shown = 0;
  for (int trial = 0; trial < trials; ++trial) {
    double sum = 0, squares = 0;
    for (int i = 0; i < n; ++i) {
      const double d = normal(engine, 0.8, 1);
      sum += d;
      squares += d * d;
    }
    const double mean = sum / n, variance = (squares - n * mean * mean) / (n - 1);
    shown +=
        std::abs(mean) / std::sqrt(variance / n) > 2.200985 ? 1 : 0;  // t of 11 degrees, 97.5 %
  }
  EXPECT_NEAR(paired_t_power(n, 0.8, 1, 0.05), static_cast<double>(shown) / trials, 0.022);
}

TEST(Power, GrowsFromPairToPair) {
  for (double n = 2; n < 1200; ++n)
    EXPECT_LT(paired_t_power(n, 0.09, 1, 0.05), paired_t_power(n + 1, 0.09, 1, 0.05)) << n;
  EXPECT_EQ(paired_t_power(1, 1, 1, 0.05), 0);
  // With one degree of freedom even 22 standard deviations are seen in 98.5 % of pairs only: the
  // difference is shown where |mean| sqrt(2) / s > 12.71, and s is |z| sd, P(|z| < 31.1 / 12.71).
  EXPECT_NEAR(paired_t_power(2, 22, 1, 0.05), std::erf(31.1 / 12.706 / std::sqrt(2.0)), 2e-3);
  EXPECT_NEAR(paired_t_power(100000, 1, 1, 0.05), 1, 1e-12);
}

TEST(Power, MinPairsAreThoseOfOneSign) {
  EXPECT_EQ(min_pairs(0.05), 6u);  // 2 / 2^6 = 0.031, 2 / 2^5 = 0.0625
  EXPECT_EQ(min_pairs(0.01), 8u);
}

}  // namespace
}  // namespace slalom
