// SPDX-License-Identifier: BSD-3-Clause
// Compares the statistics with those of R; skipped if Rscript is not installed.
#include "r_test.h"

#include <slalom/core/random.h>
#include <slalom/core/text.h>
#include <slalom/statistics/friedman.h>
#include <slalom/statistics/paired_rates.h>
#include <slalom/statistics/power.h>
#include <slalom/statistics/rank_statistics.h>
#include <slalom/statistics/survival.h>
#include <slalom/statistics/two_samples.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

class AgainstR : public RTest {
 protected:
  static std::string c(const std::vector<double>& values) {
    std::vector<std::string> parts;
    for (const double value : values) parts.push_back(format_number(value));
    return "c(" + join(parts, ",") + ")";
  }
};

std::vector<double> normals(RandomEngine& engine, int n, double mean) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(normal(engine, mean, 1));
  return values;
}

TEST_F(AgainstR, SignedRankTestAndItsShift) {
  RandomEngine engine(1);
  for (const int n : {7, 20, 49, 150}) {
    const std::vector<double> d = normals(engine, n, 0.3);
    // R is exact below 50; above, it uses the normal approximation for the shift.
    const auto expected =
        r("w <- wilcox.test(" + c(d) +
          ", conf.int = TRUE); cat(w$statistic, w$p.value, w$conf.int, w$estimate)");
    ASSERT_EQ(expected.size(), 5u);
    const SignedRankTest test = signed_rank_test(d);
    const Shift shift = hodges_lehmann(d, 0.95);
    EXPECT_DOUBLE_EQ(test.statistic, expected[0]) << n;
    EXPECT_NEAR(test.p, expected[1], 1e-9) << n;
    const double tolerance = n < 50 ? 1e-9 : 0.02;
    EXPECT_NEAR(shift.interval->low, expected[2], tolerance) << n;
    EXPECT_NEAR(shift.interval->high, expected[3], tolerance) << n;
    EXPECT_NEAR(shift.estimate, expected[4], n < 50 ? 1e-9 : 1e-3) << n;
  }
}

TEST_F(AgainstR, SignedRankTestWithTiesAndZeros) {
  RandomEngine engine(2);
  std::vector<double> d;
  for (int i = 0; i < 150; ++i) d.push_back(uniform_int(engine, -4, 5));
  const auto expected = r("cat(wilcox.test(" + c(d) + ", exact = FALSE)$p.value)");
  ASSERT_EQ(expected.size(), 1u);
  EXPECT_NEAR(signed_rank_test(d).p, expected[0], 1e-9);
}

TEST_F(AgainstR, McNemarHolmAndSuperiority) {
  const auto binomial = r("cat(binom.test(3, 14)$p.value)");
  ASSERT_EQ(binomial.size(), 1u);
  EXPECT_NEAR(mcnemar_exact(3, 11), binomial[0], 1e-12);
  const std::vector<double> p = {0.02, 0.001, 0.3, 0.04, 0.011, 0.9};
  const auto holm = r("cat(p.adjust(" + c(p) + ", 'holm'))");
  ASSERT_EQ(holm.size(), p.size());
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_NEAR(holm_adjusted(p)[i], holm[i], 1e-12);
  RandomEngine engine(3);
  const auto a = normals(engine, 13, 0.5), b = normals(engine, 9, 0);
  const auto w = r("cat(wilcox.test(" + c(a) + "," + c(b) + ")$statistic)");
  ASSERT_EQ(w.size(), 1u);
  EXPECT_NEAR(probability_of_superiority(a, b), w[0] / (13 * 9), 1e-12);
}

TEST_F(AgainstR, TwoSamples) {
  const auto fisher =
      r("f <- function(a, m, b, n) fisher.test(matrix(c(a, m - a, b, n - b), 2))$p.value\n"
        "cat(f(1, 15, 15, 15), f(5, 10, 8, 10), f(120, 400, 90, 350))");
  ASSERT_EQ(fisher.size(), 3u);
  EXPECT_NEAR(fisher_exact(1, 15, 15, 15) / fisher[0], 1, 1e-9);
  EXPECT_NEAR(fisher_exact(5, 10, 8, 10), fisher[1], 1e-9);
  EXPECT_NEAR(fisher_exact(120, 400, 90, 350), fisher[2], 1e-9);
  RandomEngine engine(7);
  const auto a = normals(engine, 13, 0.5), b = normals(engine, 9, 0);
  const auto small = r("cat(wilcox.test(" + c(a) + "," + c(b) + ")$p.value, t.test(" + c(a) + "," +
                       c(b) + ")$conf.int)");
  ASSERT_EQ(small.size(), 3u);
  EXPECT_NEAR(rank_sum_test(a, b).p, small[0], 1e-9);
  EXPECT_NEAR(welch_interval(a, b, 0.95)->low, small[1], 1e-9);
  EXPECT_NEAR(welch_interval(a, b, 0.95)->high, small[2], 1e-9);
  std::vector<double> x, y;
  for (int i = 0; i < 70; ++i) x.push_back(uniform_int(engine, 0, 9));
  for (int i = 0; i < 60; ++i) y.push_back(uniform_int(engine, 1, 10));
  const auto large = r("cat(wilcox.test(" + c(x) + "," + c(y) + ", exact = FALSE)$p.value)");
  ASSERT_EQ(large.size(), 1u);
  EXPECT_FALSE(rank_sum_test(x, y).exact);
  EXPECT_NEAR(rank_sum_test(x, y).p, large[0], 1e-9);
}

TEST_F(AgainstR, WilsonStudentAndPower) {
  const auto wilson = r("cat(prop.test(17, 60, correct = FALSE)$conf.int)");
  ASSERT_EQ(wilson.size(), 2u);
  EXPECT_NEAR(wilson_interval(17 / 60.0, 60, 0.95).low, wilson[0], 1e-9);
  EXPECT_NEAR(wilson_interval(17 / 60.0, 60, 0.95).high, wilson[1], 1e-9);
  RandomEngine engine(4);
  const auto values = normals(engine, 11, 2);
  ScenarioGroups groups;
  for (const double value : values) groups.push_back({value});
  const auto student = r("cat(t.test(" + c(values) + ", conf.level = 0.9)$conf.int)");
  ASSERT_EQ(student.size(), 2u);
  EXPECT_NEAR(t_interval(sums_of(groups), 0.9)->low, student[0], 1e-9);
  EXPECT_NEAR(t_interval(sums_of(groups), 0.9)->high, student[1], 1e-9);
  const auto power =
      r("cat(power.t.test(n = 23, delta = 0.6, type = 'paired', strict = TRUE)$power)");
  ASSERT_EQ(power.size(), 1u);
  EXPECT_NEAR(paired_t_power(23, 0.6, 1, 0.05), power[0], 1e-7);
}

TEST_F(AgainstR, PairsNeededOfAnyNumber) {
  for (const double relevant : {1.1, 0.5, 0.12, 0.087, 0.0561, 0.031, 0.0123, 0.004}) {
    for (const double power : {0.8, 0.95}) {
      const std::string common =
          "type = 'paired', strict = TRUE, tol = 1e-9, delta = " + format_number(relevant) +
          ", power = " + format_number(power);
      const auto n = r("cat(ceiling(power.t.test(" + common + ")$n))");
      ASSERT_EQ(n.size(), 1u);
      EXPECT_EQ(static_cast<double>(required_pairs(relevant, 1, 0.05, power)), n[0])
          << relevant << " " << power;
    }
  }
}

TEST_F(AgainstR, FriedmanNemenyiAndSpearman) {
  RandomEngine engine(5);
  std::vector<std::vector<double>> values;
  std::vector<double> flat;
  for (int i = 0; i < 12; ++i) {
    std::vector<double> row;
    for (int j = 0; j < 4; ++j) row.push_back(uniform_int(engine, 0, 5));
    flat.insert(flat.end(), row.begin(), row.end());
    values.push_back(row);
  }
  const auto friedman = r("f <- friedman.test(matrix(" + c(flat) +
                          ", 12, byrow = TRUE)); cat(f$statistic, f$p.value)");
  ASSERT_EQ(friedman.size(), 2u);
  const FriedmanTest test = friedman_test(values, false, 0.05);
  EXPECT_NEAR(test.chi_squared, friedman[0], 1e-9);
  EXPECT_NEAR(test.p, friedman[1], 1e-9);
  const auto range = r("cat(qtukey(0.95, c(2, 5, 12), Inf))");
  ASSERT_EQ(range.size(), 3u);
  EXPECT_NEAR(studentized_range_quantile(0.05, 2), range[0], 1e-6);
  EXPECT_NEAR(studentized_range_quantile(0.05, 5), range[1], 1e-6);
  EXPECT_NEAR(studentized_range_quantile(0.05, 12), range[2], 1e-6);
  std::vector<double> x, y;
  for (int i = 0; i < 30; ++i) {
    x.push_back(uniform_int(engine, 0, 9));
    y.push_back(x.back() + uniform_int(engine, 0, 9));
  }
  const auto rho = r("cat(cor(" + c(x) + "," + c(y) + ", method = 'spearman'))");
  ASSERT_EQ(rho.size(), 1u);
  EXPECT_NEAR(*spearman(x, y, 0.95).rho, rho[0], 1e-12);
}

TEST_F(AgainstR, CompletionCurves) {
  RandomEngine engine(6);
  std::vector<TimedEnd> ends;
  std::vector<double> times, causes;
  for (int i = 0; i < 40; ++i) {
    ends.push_back({static_cast<double>(uniform_int(engine, 1, 15)), uniform_int(engine, 0, 2)});
    times.push_back(ends.back().time);
    causes.push_back(ends.back().cause);
  }
  // Prints nothing without the survival package.
  const auto expected = r("library(survival)\nt <- " + c(times) + "; e <- factor(" + c(causes) +
                          ", 0:2)\ns <- survfit(Surv(t, e) ~ 1)\nk <- s$n.event[, 2] > 0\n"
                          "cat(rbind(s$time[k], s$pstate[k, 2]))");
  if (expected.empty()) GTEST_SKIP() << "needs the package r-cran-survival";
  const auto curve = cumulative_incidence(ends, 1);
  ASSERT_EQ(expected.size(), 2 * curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_EQ(curve[i].time, expected[2 * i]);
    EXPECT_NEAR(curve[i].value, expected[2 * i + 1], 1e-12);
  }
}

}  // namespace
}  // namespace slalom
