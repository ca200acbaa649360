// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/mean_interval.h>
#include <slalom/statistics/paired_rates.h>
#include <slalom/statistics/rank_statistics.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace slalom {
namespace {

constexpr double kMeanConfidence = 0.95;

GroupSums each_alone(const std::vector<double>& values) {
  return {values, std::vector<double>(values.size(), 1.0)};
}

std::vector<double> positives_of(const std::vector<double>& values) {
  std::vector<double> positives;
  for (const double value : values) positives.push_back(value != 0 ? 1 : 0);
  return positives;
}

Interval hurdle(const std::vector<double>& values, double high = 1) {
  return hurdle_interval(score_moments(each_alone(values), positives_of(values)), high,
                         kMeanConfidence);
}

Interval gaffke(const std::vector<double>& values, const Range& range) {
  const GroupSums groups = each_alone(values);
  return *gaffke_interval(moments_of(groups), groups, range, kMeanConfidence);
}

double exponential(RandomEngine& engine) {
  return -std::log1p(-uniform_real(engine, 0, 1));
}

/// A gamma variable of integer shape is a sum of exponential ones.
double gamma_value(RandomEngine& engine, int shape) {
  double sum = 0;
  for (int i = 0; i < shape; ++i) sum += exponential(engine);
  return sum;
}

double beta_value(RandomEngine& engine, int a, int b) {
  const double x = gamma_value(engine, a);
  return x / (x + gamma_value(engine, b));
}

/// SPL: 0 for a failure, else Beta(20, 3).
double spl(RandomEngine& engine, double success) {
  return uniform_real(engine, 0, 1) < success ? beta_value(engine, 20, 3) : 0;
}

struct Coverage {
  double covered = 0, width = 0;
};

Coverage simulate(double truth, int samples, unsigned seed,
                  const std::function<Interval(RandomEngine&)>& draw) {
  RandomEngine engine(seed);
  Coverage found;
  for (int i = 0; i < samples; ++i) {
    const Interval interval = draw(engine);
    found.covered += interval.low <= truth && truth <= interval.high ? 1 : 0;
    found.width += interval.high - interval.low;
  }
  return {found.covered / samples, found.width / samples};
}

template <typename Draw>
std::vector<double> sample(RandomEngine& engine, int n, const Draw& draw) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(draw(engine));
  return values;
}

TEST(HurdleInterval, CombinesWilsonAndStudentByHand) {
  // k = 4 of n = 5; m = 0.8, s = 0.1 by 0.7, 0.8, 0.8, 0.9: s^2 = 0.02 / 3.
  const Interval interval = hurdle({0, 0.7, 0.8, 0.8, 0.9});
  // Wilson of 4 / 5: z^2 = 3.841459; center (0.8 + 0.3841459) / 1.7682918, half z sqrt(0.032 +
  // 0.03841459) / 1.7682918: 0.3755354 to 0.9637759. t of 3 degrees 3.182446 times 0.0408248.
  const double m = 0.8, p = 0.8, t = 3.182446 * 0.0408248;
  EXPECT_NEAR(interval.low, 0.64 - std::hypot(m * (p - 0.3755354), p * t), 1e-5);
  EXPECT_NEAR(interval.high, 0.64 + std::hypot(m * (0.9637759 - p), p * t), 1e-5);
}

TEST(HurdleInterval, IsClopperAndPearsonsOfTheSumWithLessThanTwoSuccesses) {
  // No success in 10: up to 1 - 0.025^(1/10), in units of the largest score.
  const Interval none = hurdle(std::vector<double>(10, 0.0), 0.5);
  EXPECT_EQ(none.low, 0);
  EXPECT_NEAR(none.high, 0.5 * (1 - std::pow(0.025, 0.1)), 1e-9);
  std::vector<double> one(10, 0.0);
  one[3] = 0.5;
  const Interval half = hurdle(one, 0.5), exact = clopper_pearson_interval(1, 10, kMeanConfidence);
  EXPECT_NEAR(half.low, 0.5 * exact.low, 1e-12);
  EXPECT_NEAR(half.high, 0.5 * exact.high, 1e-12);
}

TEST(HurdleInterval, OfEqualValuesHasTheWidthOfARateWithoutFailures) {
  const Interval interval = hurdle(std::vector<double>(20, 0.9));
  const Interval rate = wilson_interval(1, 20, kMeanConfidence);
  EXPECT_NEAR(interval.low, 0.9 * rate.low, 1e-12);
  // Dirichlet weights of the 20 values and of 1: mean c, variance sum (x - c)^2 / (21 * 22).
  const double c = (20 * 0.9 + 1) / 21;
  const double variance = (20 * std::pow(0.9 - c, 2) + std::pow(1 - c, 2)) / (21 * 22);
  EXPECT_NEAR(interval.high, c + 1.959964 * std::sqrt(variance), 1e-6);
}

TEST(HurdleInterval, CoversWhereHighValuesAreRare) {
  // All runs succeed; a standard deviation cannot show a detour-free path that did not occur.
  for (const int n : {10, 30, 100}) {
    const Coverage found = simulate(0.5 + 0.03 * 0.5, 3000, 74, [&](RandomEngine& engine) {
      return hurdle(sample(
          engine, n, [](RandomEngine& e) { return uniform_real(e, 0, 1) < 0.03 ? 1.0 : 0.5; }));
    });
    EXPECT_GE(found.covered, 0.93) << n;
  }
}

TEST(HurdleInterval, HoldsItsMarksWithRareFailures) {
  // Coverage 0.93 to 0.99 and mean width, by statistics of 10,000 runs in numpy: 0.947 and 0.323,
  // 0.953 and 0.211, 0.956 and 0.164, 0.957 and 0.122.
  const struct {
    int n;
    double width;
  } marks[] = {{10, 0.33}, {20, 0.22}, {30, 0.17}, {50, 0.125}};
  const double truth = 0.95 * 20 / 23;
  for (const auto& mark : marks) {
    const Coverage found = simulate(truth, 6000, 71, [&](RandomEngine& engine) {
      return hurdle(sample(engine, mark.n, [](RandomEngine& e) { return spl(e, 0.95); }));
    });
    EXPECT_GE(found.covered, 0.93) << mark.n;
    EXPECT_LE(found.covered, 0.99) << mark.n;
    EXPECT_LE(found.width, mark.width) << mark.n;
    RecordProperty("coverage_" + std::to_string(mark.n), std::to_string(found.covered));
    RecordProperty("width_" + std::to_string(mark.n), std::to_string(found.width));
  }
}

TEST(HurdleInterval, CoversAtOtherRatesOfSuccess) {
  for (const double success : {0.2, 0.5, 0.8, 0.9, 0.99, 1.0})
    for (const int n : {10, 20, 50}) {
      const Coverage found = simulate(success * 20 / 23, 3000, 72, [&](RandomEngine& engine) {
        return hurdle(sample(engine, n, [&](RandomEngine& e) { return spl(e, success); }));
      });
      EXPECT_GE(found.covered, 0.93) << success << " " << n;
    }
}

TEST(HurdleInterval, CoversWithRepetitionsOfScenarios) {
  // The success of a scenario is from Beta(1, (1 - r) / r), and its runs are better the higher it
  // is: the mean of one run is the integral of p (a + b p), E p = r, E p^2 = r (1 + r) (r / (1 +
  // r)) for that distribution, which is checked by the sample.
  for (const double rate : {0.5, 0.8})
    for (const int scenarios : {10, 30}) {
      const auto draw = [rate](RandomEngine& engine, double& sum, double& positives) {
        const double p = 1 - std::pow(1 - uniform_real(engine, 0, 1), rate / (1 - rate));
        for (int j = 0; j < 3; ++j)
          if (uniform_real(engine, 0, 1) < p) {
            sum += 0.5 + 0.4 * p * uniform_real(engine, 0.5, 1);
            ++positives;
          }
      };
      RandomEngine many(5);
      double truth = 0, ignored = 0;
      for (int i = 0; i < 400000; ++i) draw(many, truth, ignored);
      truth /= 3 * 400000.0;
      const Coverage found = simulate(truth, 3000, 73, [&](RandomEngine& engine) {
        GroupSums groups;
        std::vector<double> positives;
        for (int i = 0; i < scenarios; ++i) {
          groups.sums.push_back(0);
          groups.sizes.push_back(3);
          positives.push_back(0);
          draw(engine, groups.sums.back(), positives.back());
        }
        return hurdle_interval(score_moments(groups, positives), 1, kMeanConfidence);
      });
      EXPECT_GE(found.covered, 0.93) << rate << " " << scenarios;
      EXPECT_LE(found.covered, 0.99) << rate << " " << scenarios;
    }
}

TEST(DifferenceInterval, OfPairedScoresCoversTheirDifference) {
  // Pairs share the scenario's difficulty: both succeed if a common uniform number is below their
  // rate in 70 % of the scenarios, and independently in the others.
  const struct { double a, b; } cases[] = {{0.9, 0.8}, {0.85, 0.8}, {0.98, 0.95}, {0.95, 0.95}};
  for (const auto& rates : cases)
    for (const int n : {20, 30, 50}) {
      const double truth = (rates.a - rates.b) * 20 / 23;
      const Coverage found = simulate(truth, 2500, 74, [&](RandomEngine& engine) {
        std::vector<double> a, b;
        for (int i = 0; i < n; ++i) {
          const bool common = uniform_real(engine, 0, 1) < 0.7;
          const double u = uniform_real(engine, 0, 1), v = common ? u : uniform_real(engine, 0, 1);
          const double efficiency = beta_value(engine, 20, 3);
          a.push_back(u < rates.a ? efficiency : 0);
          b.push_back(v < rates.b ? (common ? efficiency : beta_value(engine, 20, 3)) : 0);
        }
        return difference_interval(mean(a), hurdle(a), mean(b), hurdle(b),
                                   pearson(a, b).value_or(0));
      });
      EXPECT_GE(found.covered, 0.93) << rates.a << " " << rates.b << " " << n;
      RecordProperty(
          "coverage_" + std::to_string(static_cast<int>(100 * rates.a)) + "_" + std::to_string(n),
          std::to_string(found.covered));
    }
}

TEST(DifferenceInterval, OfRatesIsNewcombes) {
  // Newcombe 1998, Stat. Med. 17:873, table II, method 10: 56 / 70 - 48 / 80.
  const Interval interval = difference_interval(0.8, wilson_interval(0.8, 70, kMeanConfidence), 0.6,
                                                wilson_interval(0.6, 80, kMeanConfidence), 0);
  EXPECT_NEAR(interval.low, 0.0524, 5e-5);
  EXPECT_NEAR(interval.high, 0.3339, 5e-5);
}

TEST(GaffkeInterval, OfEqualValuesIsTheBetaQuantile) {
  // The weight of the bound among n + 1 is Beta(1, n): 1 - (1 - w)^n.
  const Interval interval = gaffke(std::vector<double>(20, 0.6), Range::between(0, 1));
  const double weight = 1 - std::pow(0.025, 1.0 / 20);
  EXPECT_NEAR(interval.high, 0.6 + 0.4 * weight, 2e-3);
  EXPECT_NEAR(interval.low, 0.6 - 0.6 * weight, 2e-3);
}

TEST(GaffkeInterval, AgreesWithDrawsFromTheDirichletDistribution) {
  RandomEngine engine(31);
  for (const int n : {1, 2, 5, 20, 100}) {
    const std::vector<double> values =
        sample(engine, n, [](RandomEngine& e) { return beta_value(e, 8, 2); });
    std::vector<double> upper, lower;
    for (int draw = 0; draw < 40000; ++draw) {
      double sum = 0;
      double total = exponential(engine);
      const double bound = total;
      for (const double value : values) {
        const double weight = exponential(engine);
        sum += weight * value;
        total += weight;
      }
      lower.push_back(sum / total);
      upper.push_back((sum + bound) / total);
    }
    std::sort(upper.begin(), upper.end());
    std::sort(lower.begin(), lower.end());
    const Interval interval = gaffke(values, Range::between(0, 1));
    const auto level = [](const std::vector<double>& sorted, double value) {
      return static_cast<double>(std::lower_bound(sorted.begin(), sorted.end(), value) -
                                 sorted.begin()) /
             static_cast<double>(sorted.size());
    };
    EXPECT_NEAR(level(upper, interval.high), 0.975, 0.004) << n;
    EXPECT_NEAR(level(lower, interval.low), 0.025, 0.004) << n;
  }
}

TEST(GaffkeInterval, CoversMeansOfBoundedValues) {
  const struct {
    const char* name;
    double truth;
    double (*draw)(RandomEngine&);
  } sources[] = {
      {"spl", 0.95 * 20 / 23, [](RandomEngine& e) { return spl(e, 0.95); }},
      {"beta", 0.8, [](RandomEngine& e) { return beta_value(e, 8, 2); }},
      {"skewed", 0.2, [](RandomEngine& e) { return beta_value(e, 1, 4); }},
      {"rare", 0.03, [](RandomEngine& e) { return uniform_real(e, 0, 1) < 0.03 ? 1.0 : 0.0; }}};
  for (const auto& source : sources)
    for (const int n : {10, 30}) {
      const Coverage found = simulate(source.truth, 2000, 75, [&](RandomEngine& engine) {
        return gaffke(sample(engine, n, source.draw), Range::between(0, 1));
      });
      EXPECT_GE(found.covered, 0.95) << source.name << " " << n;
      RecordProperty(source.name + std::string("_") + std::to_string(n),
                     std::to_string(found.covered) + " " + std::to_string(found.width));
    }
}

TEST(GaffkeInterval, OfManyScenariosIsNearlyTheSameFromMoments) {
  RandomEngine engine(33);
  const std::vector<double> values =
      sample(engine, 500, [](RandomEngine& e) { return spl(e, 0.9); });
  const Interval exact = gaffke(values, Range::between(0, 1));
  const auto normal =
      gaffke_interval(moments_of(each_alone(values)), {}, Range::between(0, 1), kMeanConfidence);
  const double width = exact.high - exact.low;
  EXPECT_NEAR(normal->low, exact.low, 0.04 * width);
  EXPECT_NEAR(normal->high, exact.high, 0.04 * width);
}

TEST(GaffkeInterval, CountsScenariosNotRuns) {
  const std::vector<double> values = {0.2, 0.9, 0.5, 0.7};
  GroupSums thrice;
  for (const double value : values) {
    thrice.sums.push_back(3 * value);
    thrice.sizes.push_back(3);
  }
  const auto repeated =
      gaffke_interval(moments_of(thrice), thrice, Range::between(0, 1), kMeanConfidence);
  const Interval once = gaffke(values, Range::between(0, 1));
  EXPECT_NEAR(repeated->low, once.low, 1e-9);
  EXPECT_NEAR(repeated->high, once.high, 1e-9);
}

TEST(GaffkeInterval, DoesNotExistForValuesOutsideTheRange) {
  const GroupSums groups = each_alone({0.2, 1.4});
  EXPECT_FALSE(gaffke_interval(moments_of(groups), groups, Range::between(0, 1), kMeanConfidence));
}

TEST(MedianInterval, HasTheRanksOfTheBinomialDistribution) {
  // Conover 1999, table A3: of 10 values the 2nd and the 9th (0.9785), of 20 the 6th and the 15th
  // (0.9586); 5 values have none, since 2 / 2^5 > 0.05.
  const auto ranks = [](int n) {
    std::vector<double> values(static_cast<std::size_t>(n));
    std::iota(values.begin(), values.end(), 1.0);
    return median_interval(values, std::vector<std::size_t>(values.size(), 1), kMeanConfidence);
  };
  EXPECT_EQ(ranks(10)->low, 2);
  EXPECT_EQ(ranks(10)->high, 9);
  EXPECT_EQ(ranks(20)->low, 6);
  EXPECT_EQ(ranks(20)->high, 15);
  EXPECT_EQ(ranks(6)->low, 1);
  EXPECT_FALSE(ranks(5));
}

TEST(MedianInterval, CoversTheMedianOfSkewedTimes) {
  // Lognormal times, with 5 % detours of three to five times.
  const auto time = [](RandomEngine& engine) {
    const double detour = uniform_real(engine, 0, 1) < 0.05 ? uniform_real(engine, 3, 5) : 1;
    return detour * std::exp(normal(engine, 0, 0.3));
  };
  RandomEngine many(6);
  const double truth = median(sample(many, 400001, time));
  for (const int n : {10, 30}) {
    const Coverage found = simulate(truth, 2000, 76, [&](RandomEngine& engine) {
      const auto values = sample(engine, n, time);
      return *median_interval(values, std::vector<std::size_t>(values.size(), 1), kMeanConfidence);
    });
    EXPECT_GE(found.covered, 0.945) << n;
  }
}

TEST(MedianInterval, OfRepeatedValuesIsThatOfTheScenarios) {
  std::vector<double> values;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 4; ++j) values.push_back(i + 1);
  const auto interval = median_interval(values, std::vector<std::size_t>(20, 4), kMeanConfidence);
  // Two runs' worth of scenarios more than 20 independent values, by the variance's k / (k - 1).
  EXPECT_LE(interval->low, 6);
  EXPECT_GE(interval->high, 15);
  EXPECT_GE(interval->low, 5);
  EXPECT_LE(interval->high, 16);
}

TEST(MedianInterval, OfEqualValuesDoesNotExist) {
  EXPECT_FALSE(median_interval(std::vector<double>(30, 2.0), std::vector<std::size_t>(30, 1),
                               kMeanConfidence));
}

TEST(ClopperPearsonInterval, CoversEveryExtremeRate) {
  // Exactly, over all outcomes of 30 and 50 runs; Wilson's covers 0.848 at 0.9945 of 30.
  for (const int n : {30, 50})
    for (const double rate : {0.5, 0.9, 0.95, 0.99, 0.9945, 0.995, 0.9965, 0.999}) {
      double covered = 0, score = 0;
      for (int k = 0; k <= n; ++k) {
        const double below = k == 0 ? 0 : distributions::binomial_cdf(k - 1, n, rate);
        const double probability = distributions::binomial_cdf(k, n, rate) - below;
        const Interval exact = clopper_pearson_interval(k, n, kMeanConfidence),
                       wilson = wilson_interval(static_cast<double>(k) / n, n, kMeanConfidence);
        if (exact.low <= rate && rate <= exact.high) covered += probability;
        if (wilson.low <= rate && rate <= wilson.high) score += probability;
      }
      EXPECT_GE(covered, 0.95) << n << " " << rate;
      if (n == 30 && rate == 0.9945) {
        EXPECT_NEAR(score, 0.848, 0.001);
      }
    }
}

}  // namespace
}  // namespace slalom
