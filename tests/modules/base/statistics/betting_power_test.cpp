// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/betting.h>
#include <slalom/statistics/distributions.h>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace slalom {
namespace {

/// A method in one scenario: it arrives if a normal variable that shares 0.6 of its variance with
/// all methods in this scenario is small enough; its SPL is then of a Beta distribution of this
/// mean and a concentration of 20, with a rank that shares 0.7 with all.
struct ModelMethod {
  double success = 0.9, efficiency = 0.8;

  double spl(RandomEngine& engine, double ease) const {
    const boost::math::normal standard;
    const double arrival = std::sqrt(0.6) * ease + std::sqrt(0.4) * normal(engine, 0, 1),
                 rank = std::sqrt(0.7) * ease + std::sqrt(0.3) * normal(engine, 0, 1);
    if (arrival < quantile(standard, 1 - success)) return 0;
    const boost::math::beta_distribution<> beta(20 * efficiency, 20 * (1 - efficiency));
    return quantile(beta, std::clamp(cdf(standard, rank), 1e-9, 1 - 1e-9));
  }
};

/// The sorted numbers of scenarios after which a is shown to be better than b at 0.025 by its SPL,
/// or by its successes alone; 2000 where it is not shown by then.
std::vector<int> scenarios_until_shown(const ModelMethod& a, const ModelMethod& b,
                                       bool by_success) {
  std::vector<int> counts;
  for (std::uint64_t campaign = 0; campaign < 400; ++campaign) {
    RandomEngine engine(derive_seed(5, "campaign", campaign));
    BettingTest test(0, 0.05, 1);
    int count = 0;
    while (count < 2000 && test.p() > 0.025) {
      const double ease = normal(engine, 0, 1), of_a = a.spl(engine, ease),
                   of_b = b.spl(engine, ease);
      test.add(by_success ? (of_a > 0) - (of_b > 0) : of_a - of_b);
      ++count;
    }
    counts.push_back(count);
  }
  std::sort(counts.begin(), counts.end());
  return counts;
}

TEST(BettingTest, ShowsADifferenceInSuccessAndEfficiencyByHalfOfTheScenariosThatSuccessNeeds) {
  const ModelMethod a = {0.9, 0.85}, b = {0.8, 0.8};
  const auto spl = scenarios_until_shown(a, b, false), success = scenarios_until_shown(a, b, true);
  EXPECT_LE(spl[200], 75);
  EXPECT_LE(spl[360], 140);
  EXPECT_LE(spl[200], 0.55 * success[200]);
  EXPECT_LE(spl[360], 0.55 * success[360]);
}

TEST(BettingTest, ShowsADifferenceThatIsLessThanHalfOfTheEffectItBetsOn) {
  // A bettor on 0.1 alone loses: with a stake of 0.1 / 0.4 the logarithm of its wealth changes by
  // about 0.25 * 0.043 - 0.25^2 * 0.4 / 2 < 0 in the mean.
  int shown = 0;
  for (std::uint64_t campaign = 0; campaign < 200; ++campaign) {
    RandomEngine engine(derive_seed(6, "campaign", campaign));
    BettingTest test(0, 0.1, 1);
    for (int i = 0; i < 5000 && test.p() > 0.025; ++i) {
      const double u = uniform_real(engine, 0, 1);
      test.add(u < 0.2215 ? 1 : u < 0.4 ? -1 : 0);  // a mean of 0.043
    }
    shown += test.p() <= 0.025;
  }
  EXPECT_GE(shown, 165);
}

TEST(BettingTest, RejectsTrueHypothesesInAtMostTheirLevel) {
  using Draw = std::function<double(RandomEngine&)>;
  const auto spl_difference = [](const ModelMethod& a, const ModelMethod& b) -> Draw {
    return [a, b](RandomEngine& engine) {
      const double ease = normal(engine, 0, 1), of_a = a.spl(engine, ease);
      return of_a - b.spl(engine, ease);
    };
  };
  const auto steps = [](double up, double chance, double down) -> Draw {
    return [=](RandomEngine& engine) { return uniform_real(engine, 0, 1) < chance ? up : down; };
  };
  const std::vector<std::pair<Draw, int>> nulls = {
      {spl_difference({0.9, 0.8}, {0.9, 0.8}), 100},
      {spl_difference({0.8, 0.9}, {0.9, 0.8}), 100},  // the same mean of 0.72
      {steps(0.05, 0.9, -0.45), 1000},
      {steps(1.0 / 99, 0.99, -1), 1000},
      {steps(1, 0.01, -1.0 / 99), 1000},
      {steps(1, 0.5, -1), 1000},
      {[](RandomEngine& engine) {
         const double u = uniform_real(engine, 0, 1);
         return u < 0.02 ? 0.85 : u < 0.04 ? -0.85 : 0;
       },
       1000}};
  for (std::size_t null = 0; null < nulls.size(); ++null) {
    int rejected = 0;
    const auto& [draw, length] = nulls[null];
    for (std::uint64_t campaign = 0; campaign < 1000; ++campaign) {
      RandomEngine engine(derive_seed(null, "campaign", campaign));
      BettingTest above(0, 0.05, 1), below(0, -0.05, 1);
      for (int i = 0; i < length; ++i) {
        const double value = draw(engine);
        above.add(value);
        below.add(value);
      }
      rejected += above.p() <= 0.025 || below.p() <= 0.025;
    }
    EXPECT_LE(distributions::binomial_lower_bound(rejected, 1000, 0.005), 0.05) << null;
  }
}

}  // namespace
}  // namespace slalom
