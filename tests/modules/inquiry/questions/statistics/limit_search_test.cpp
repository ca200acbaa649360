// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/inquiry/limit_search.h>
#include <slalom/statistics/distributions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace slalom {
namespace {

constexpr std::size_t kBins = 35;  // of 2 cm, from 1.2 to 0.5 m
constexpr int kStudies = 400;

/// The middle of a bin, m.
double middle(std::size_t bin) {
  return 1.2 - 0.02 * (static_cast<double>(bin) + 0.5);
}

/// The rates of success by bin; drawn anew for each repetition.
using Curve = std::function<std::vector<double>(RandomEngine&)>;

/// A curve with a threshold between 0.6 and 0.9 m.
Curve with_threshold(const std::function<double(double width, double threshold)>& rate) {
  return [rate](RandomEngine& engine) {
    const double threshold = uniform_real(engine, 0.6, 0.9);
    std::vector<double> rates(kBins);
    for (std::size_t i = 0; i < kBins; ++i) rates[i] = rate(middle(i), threshold);
    return rates;
  };
}

/// Runs that succeed with these rates; a run in several bins is in any of them.
RunBins runs_with(const std::vector<double>& rates, RandomEngine& engine) {
  return [&rates, &engine](LimitPhase, const BinRange& bins, std::size_t max_runs,
                           const std::function<bool(bool)>& receive) {
    for (std::size_t i = 0; i < max_runs; ++i) {
      const int bin =
          uniform_int(engine, static_cast<int>(bins.first), static_cast<int>(bins.end) - 1);
      if (!receive(uniform_real(engine, 0, 1) < rates[static_cast<std::size_t>(bin)])) break;
    }
    return true;
  };
}

LimitOptions options_of_35_bins() {
  LimitOptions options;
  options.bins = kBins;
  return options;
}

struct Study {
  int nothing = 0;                           ///< repetitions without a claim
  int too_good = 0;                          ///< a claimed bin, or one before it, is below the rate
  int wrong = 0;                             ///< the rate in a claimed step is below it
  std::vector<int> behind;                   ///< bins from the claim to the truth
  std::vector<std::size_t> pilot_and_claim;  ///< runs
};

Study study(const Curve& curve, const LimitOptions& options = options_of_35_bins(),
            int repeats = kStudies) {
  RandomEngine engine(1);
  Study study;
  for (int i = 0; i < repeats; ++i) {
    const std::vector<double> rates = curve(engine);
    const LimitResult result = find_limit(options, runs_with(rates, engine));
    const auto is_low = [](double rate) { return rate < 0.95; };
    const auto truth = std::find_if(rates.begin(), rates.end(), is_low) - rates.begin();
    std::size_t claimed = 0, runs = 0;
    bool wrong = false;
    for (const BinRuns& step : result.steps) {
      runs += step.runs;
      if (!step.reached) continue;
      claimed = step.bins.end;
      double mean = 0;
      for (std::size_t bin = step.bins.first; bin < step.bins.end; ++bin) mean += rates[bin];
      wrong = wrong || mean / static_cast<double>(step.bins.end - step.bins.first) < 0.95;
    }
    for (const BinRuns& probe : result.pilot) runs += probe.runs;
    study.nothing += claimed == 0 ? 1 : 0;
    study.too_good += static_cast<std::ptrdiff_t>(claimed) > truth ? 1 : 0;
    study.wrong += wrong ? 1 : 0;
    study.behind.push_back(static_cast<int>(truth) - static_cast<int>(claimed));
    study.pilot_and_claim.push_back(runs);
  }
  std::sort(study.behind.begin(), study.behind.end());
  std::sort(study.pilot_and_claim.begin(), study.pilot_and_claim.end());
  return study;
}

template <typename Value>
Value quantile(const std::vector<Value>& sorted, double q) {
  return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1))];
}

/// Whether a probability of at most `p` may have given so many, at 97.5 % (Clopper-Pearson).
bool may_be(int count, int n, double p) {
  return distributions::binomial_lower_bound(count, n, 0.025) <= p;
}

TEST(FindLimit, FindsASharpThreshold) {
  const Study sharp = study(with_threshold(
      [](double width, double threshold) { return width >= threshold ? 0.999 : 0.3; }));
  EXPECT_EQ(quantile(sharp.behind, 0.5), 0);
  EXPECT_LE(quantile(sharp.behind, 0.9), 1);
  EXPECT_LE(quantile(sharp.pilot_and_claim, 0.5), 1000U);
  EXPECT_TRUE(may_be(sharp.too_good, kStudies, 0.05)) << sharp.too_good;
}

TEST(FindLimit, FindsASoftThreshold) {
  const Study soft = study(with_threshold([](double width, double threshold) {
    return 1 / (1 + std::exp(-((width - threshold) / 0.04 + std::log(19))));
  }));
  EXPECT_LE(quantile(soft.behind, 0.5), 2);
  EXPECT_TRUE(may_be(soft.too_good, kStudies, 0.05)) << soft.too_good;
}

TEST(FindLimit, FindsTheEndOfAPlateauNotMuchAboveTheRate) {
  const Study plateau = study(with_threshold(
      [](double width, double threshold) { return width >= threshold ? 0.98 : 0.3; }));
  EXPECT_TRUE(may_be(plateau.nothing, kStudies, 0.03)) << plateau.nothing;
  EXPECT_LE(quantile(plateau.pilot_and_claim, 0.5), 3000U);
  EXPECT_TRUE(may_be(plateau.wrong, kStudies, 0.05)) << plateau.wrong;
}

TEST(FindLimit, RarelyClaimsWhatIsNotTrue) {
  const int repeats = 1000;
  const Study below = study([](RandomEngine&) { return std::vector<double>(kBins, 0.95 - 1e-4); },
                            options_of_35_bins(), repeats);
  EXPECT_TRUE(may_be(repeats - below.nothing, repeats, 0.05)) << repeats - below.nothing;
  const Study trap = study([](RandomEngine& engine) {
    std::vector<double> rates(kBins);
    const double threshold = uniform_real(engine, 0.6, 0.7);
    for (std::size_t i = 0; i < kBins; ++i) rates[i] = middle(i) >= threshold ? 0.995 : 0.3;
    rates[static_cast<std::size_t>(uniform_int(engine, 5, 19))] = 0.5;
    return rates;
  });
  EXPECT_TRUE(may_be(trap.too_good, kStudies, 0.05)) << trap.too_good;
}

/// A block of several bins hides a shallow trap in its mixture, which is what it claims.
TEST(FindLimit, WithoutBlocksClaimsEachBin) {
  const Curve shallow = [](RandomEngine& engine) {
    std::vector<double> rates(kBins, 0.995);
    rates[static_cast<std::size_t>(uniform_int(engine, 5, 19))] = 0.9;
    return rates;
  };
  LimitOptions options = options_of_35_bins();
  const Study blocks = study(shallow);
  EXPECT_TRUE(may_be(blocks.wrong, kStudies, 0.05)) << blocks.wrong;
  EXPECT_GT(blocks.too_good, kStudies / 4);
  options.blocks = 0;
  const Study bins = study(shallow, options);
  EXPECT_TRUE(may_be(bins.too_good, kStudies, 0.05)) << bins.too_good;
}

TEST(FindLimit, StepsAreSixBlocksThenBins) {
  RandomEngine engine(1);
  std::vector<double> rates(kBins, 0);
  for (std::size_t i = 0; i < 23; ++i) rates[i] = 1;
  const LimitResult result = find_limit(options_of_35_bins(), runs_with(rates, engine));
  // The pilot finds 23 bins; 20 of them in six blocks, rounded to 3, 7, 10, 13, 17, 20.
  const std::size_t ends[] = {3, 7, 10, 13, 17, 20, 21, 22, 23, 24};
  ASSERT_EQ(result.steps.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(result.steps[i].bins.first, i == 0 ? 0 : ends[i - 1]);
    EXPECT_EQ(result.steps[i].bins.end, ends[i]);
    EXPECT_EQ(result.steps[i].runs, i < 9 ? 67U : RateTest::kMinFutileRuns);
  }
  EXPECT_EQ(result.claimed(), 9U);
  ASSERT_EQ(result.curve.size(), 5U);
  EXPECT_EQ(result.curve[0].bins.first, 23U);
  EXPECT_EQ(result.curve[0].failures, 30U);
  EXPECT_TRUE(result.complete);
}

TEST(FindLimit, SeesThatTheEndsAreExchanged) {
  RandomEngine engine(1);
  for (const std::size_t threshold : {5U, 17U, 18U, 30U}) {
    std::vector<double> rates(kBins, 0);
    for (std::size_t i = threshold; i < kBins; ++i) rates[i] = 1;
    const LimitResult result = find_limit(options_of_35_bins(), runs_with(rates, engine));
    EXPECT_TRUE(result.exchanged) << threshold;
    EXPECT_TRUE(result.steps.empty());
  }
  for (const double rate : {0.0, 1.0})
    EXPECT_FALSE(
        find_limit(options_of_35_bins(), runs_with(std::vector<double>(kBins, rate), engine))
            .exchanged);
}

TEST(FindLimit, EndsWhereItIsInterrupted) {
  int calls = 0;
  const LimitResult result =
      find_limit(options_of_35_bins(),
                 [&](LimitPhase, const BinRange&, std::size_t runs, const auto& receive) {
                   for (std::size_t i = 0; i < runs && receive(true);) ++i;
                   return ++calls < 9;
                 });
  EXPECT_FALSE(result.complete);
  EXPECT_FALSE(result.exchanged);
}

}  // namespace
}  // namespace slalom
