// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/rasch.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace slalom {
namespace {

/// Knuth's linear congruential generator, which is easy to write in any language.
class Lcg {
 public:
  explicit Lcg(std::uint64_t seed) : state_(seed) {}
  double operator()() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 11U) / 9007199254740992.0;
  }

 private:
  std::uint64_t state_;
};

/// Outcomes of eight methods with abilities of -1.75 to 1.75 in steps of 0.5 in scenarios with
/// difficulties of -2.5 to 2.5; `slope`: of every second method.
OutcomeMatrix made(std::uint64_t seed, int scenarios, double slope) {
  Lcg uniform(seed);
  OutcomeMatrix outcomes;
  for (int i = 0; i < scenarios; ++i) {
    const double difficulty = 5 * uniform() - 2.5;
    outcomes.emplace_back();
    for (int method = 0; method < 8; ++method) {
      const double z = (method % 2 == 1 ? slope : 1) * (0.5 * method - 1.75 - difficulty);
      outcomes.back().push_back(uniform() < 1 / (1 + std::exp(-z)));
    }
  }
  return outcomes;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected,
                 double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << i;
}

void expect_residuals(const OutcomeMatrix& outcomes, const RaschFit& fit,
                      const std::vector<double>& infit, const std::vector<double>& outfit) {
  const auto residuals = rasch_residuals(outcomes, fit.abilities);
  ASSERT_EQ(residuals.size(), infit.size());
  for (std::size_t i = 0; i < infit.size(); ++i) {
    EXPECT_NEAR(residuals[i].infit, infit[i], 1e-4) << i;
    EXPECT_NEAR(residuals[i].outfit, outfit[i], 1e-4) << i;
  }
}

// Expected values: eRm 1.0-2 (Mair and Hatzinger 2007) on the same outcomes: RM(x, sum0 = TRUE),
// LRtest(splitcr = "median"), itemfit(person.parameter()).
TEST(Rasch, AgreesWithErmWhereTheModelHolds) {
  const OutcomeMatrix outcomes = made(1, 300, 1);
  const RaschFit fit = fit_rasch(outcomes);
  EXPECT_EQ(fit.informative, 265U);
  EXPECT_NEAR(fit.log_likelihood, -661.8528619, 1e-6);
  expect_near(fit.abilities,
              {-2.140068891, -0.8318628337, -0.7724014705, -0.2004770377, 0.2590401307, 0.631858892,
               1.004912173, 2.048999037},
              1e-4);
  expect_near(fit.standard_errors,
              {0.1632234894, 0.1358275779, 0.135395493, 0.1336503382, 0.1352555354, 0.1386813851,
               0.1443360615, 0.1763299011},
              1e-4);
  expect_residuals(outcomes, fit,
                   {0.9037497197, 0.9795968567, 1.045489808, 0.9359325355, 0.8903455726,
                    0.9815008308, 0.8504630588, 0.8906080943},
                   {0.8092809038, 1.03508116, 1.017604946, 0.8634550788, 0.8188904716, 0.9939226323,
                    0.7488417394, 0.720366441});
  const auto test = andersen_test(outcomes);
  ASSERT_TRUE(test);
  EXPECT_EQ(test->degrees, 7U);
  EXPECT_NEAR(test->statistic, 7.031914882, 1e-4);
  EXPECT_NEAR(test->p, 0.4255644795, 1e-5);
}

TEST(Rasch, AgreesWithErmWhereMethodsDiscriminateUnequally) {
  const OutcomeMatrix outcomes = made(2, 600, 2);
  const RaschFit fit = fit_rasch(outcomes);
  EXPECT_EQ(fit.informative, 516U);
  EXPECT_NEAR(fit.log_likelihood, -1044.561929, 1e-6);
  expect_near(fit.abilities,
              {-2.037002281, -1.950006569, -1.031033901, -0.4806431978, 0.2995692383, 0.999614947,
               1.485546605, 2.713955157},
              1e-4);
  expect_residuals(outcomes, fit,
                   {1.066739883, 0.7014825943, 1.11535326, 0.6755167546, 1.052509738, 0.722292421,
                    1.05228294, 0.8418346075},
                   {1.303944951, 0.4245648555, 1.093884123, 0.5098040567, 1.129184353, 0.5514790713,
                    1.223483392, 0.535861586});
  const auto test = andersen_test(outcomes);
  ASSERT_TRUE(test);
  EXPECT_NEAR(test->statistic, 66.36071786, 1e-4);
  EXPECT_NEAR(test->p / 8.007927654e-12, 1, 1e-3);
}

// Rasch's separability: given how many methods solve a scenario, the probability of which ones they
// are does not depend on its difficulty. By enumeration of all outcomes of five methods.
RC_GTEST_PROP(Rasch, ConditionalProbabilitiesDoNotDependOnTheDifficulty, ()) {
  RandomEngine engine(*rc::gen::arbitrary<std::uint64_t>());
  std::vector<double> abilities;
  for (int i = 0; i < 5; ++i) abilities.push_back(normal(engine, 0, 2));
  const double difficulty = normal(engine, 0, 3);
  const auto row_of = [](unsigned pattern) {
    std::vector<bool> row;
    for (unsigned i = 0; i < 5; ++i) row.push_back((pattern >> i & 1U) != 0);
    return row;
  };
  const auto score_of = [](const std::vector<bool>& row) {
    return static_cast<std::size_t>(std::count(row.begin(), row.end(), true));
  };
  std::vector<double> joint(32, 1.0), of_score(6, 0.0);
  for (unsigned pattern = 0; pattern < 32; ++pattern) {
    const auto row = row_of(pattern);
    for (std::size_t i = 0; i < 5; ++i) {
      const double p = 1 / (1 + std::exp(difficulty - abilities[i]));
      joint[pattern] *= row[i] ? p : 1 - p;
    }
    of_score[score_of(row)] += joint[pattern];
  }
  for (unsigned pattern = 0; pattern < 32; ++pattern) {
    const auto row = row_of(pattern);
    const double given_score = joint[pattern] / of_score[score_of(row)];
    RC_ASSERT(std::abs(std::exp(conditional_log_likelihood({row}, abilities)) - given_score) <
              1e-9);
  }
}

/// Outcomes of methods in scenarios with normal difficulties of this deviation.
OutcomeMatrix drawn(const std::vector<double>& abilities, int scenarios, double deviation,
                    RandomEngine& engine) {
  OutcomeMatrix outcomes;
  for (int i = 0; i < scenarios; ++i) {
    const double difficulty = normal(engine, 0, deviation);
    outcomes.emplace_back();
    for (const double ability : abilities)
      outcomes.back().push_back(uniform_real(engine, 0, 1) <
                                1 / (1 + std::exp(difficulty - ability)));
  }
  return outcomes;
}

TEST(Rasch, ExpectsTheResidualsThatTheModelHasOnAverage) {
  // The abilities are estimated in each campaign, and the expectation is that of the estimates.
  const std::vector<double> abilities = {3.03, 2.31, 1.45, 1.45, -3.51, -4.72};
  RandomEngine engine(8);
  constexpr int kSimulated = 400;
  std::vector<RaschResiduals> sums(6, RaschResiduals{0, 0, 0, 0});
  for (int i = 0; i < kSimulated; ++i) {
    OutcomeMatrix outcomes = drawn(abilities, 300, 3, engine);
    while (comparable_methods(outcomes).size() < 6) outcomes = drawn(abilities, 300, 3, engine);
    const auto residuals = rasch_residuals(outcomes, fit_rasch(outcomes).abilities);
    for (std::size_t j = 0; j < 6; ++j) {
      sums[j].infit += residuals[j].infit / kSimulated;
      sums[j].outfit += residuals[j].outfit / kSimulated;
      sums[j].expected_infit += residuals[j].expected_infit / kSimulated;
      sums[j].expected_outfit += residuals[j].expected_outfit / kSimulated;
    }
  }
  for (std::size_t j = 0; j < 6; ++j) {
    EXPECT_NEAR(sums[j].infit, sums[j].expected_infit, 0.01) << j;
    EXPECT_NEAR(sums[j].outfit, sums[j].expected_outfit, 0.05) << j;
    EXPECT_LT(sums[j].expected_infit, 0.9) << "not 1: " << j;
  }
}

TEST(Rasch, ExpectsTheResidualsOfAllOutcomesWithTheirProbabilities) {
  // Two of three methods solve the scenario: three outcomes with the weights exp(sum of abilities).
  const std::vector<double> abilities = {1, 0.5, -1.5};
  const OutcomeMatrix all = {{true, true, false}, {true, false, true}, {false, true, true}};
  const std::vector<double> weights = {std::exp(1.5), std::exp(-0.5), std::exp(-1.0)};
  std::vector<double> infit(3, 0.0), outfit(3, 0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto residuals = rasch_residuals({all[k]}, abilities);
    for (std::size_t i = 0; i < 3; ++i) {
      infit[i] += residuals[i].infit * weights[k] / (weights[0] + weights[1] + weights[2]);
      outfit[i] += residuals[i].outfit * weights[k] / (weights[0] + weights[1] + weights[2]);
    }
  }
  const auto expected = rasch_residuals({all[0]}, abilities);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(expected[i].expected_infit, infit[i], 1e-9);
    EXPECT_NEAR(expected[i].expected_outfit, outfit[i], 1e-9);
  }
}

TEST(Rasch, ExpectsMeanSquaresNearOneOfManyMethods) {
  std::vector<double> abilities;
  for (int i = 0; i < 60; ++i) abilities.push_back(0.05 * i - 1.475);
  RandomEngine engine(9);
  for (const RaschResiduals& method : rasch_residuals(drawn(abilities, 50, 1, engine), abilities)) {
    EXPECT_NEAR(method.expected_infit, 1, 0.02);
    EXPECT_NEAR(method.expected_outfit, 1, 0.02);
  }
}

TEST(Rasch, OfTwoMethodsIsTheLogarithmOfTheRatioOfDiscordantScenarios) {
  // 6 scenarios that only the first solves and 2 that only the second does: log(6 / 2) apart, with
  // the standard error sqrt(1/6 + 1/2) of the difference, half of it for each.
  OutcomeMatrix outcomes(6, {true, false});
  outcomes.insert(outcomes.end(), 2, {false, true});
  outcomes.insert(outcomes.end(), 5, {true, true});
  const RaschFit fit = fit_rasch(outcomes);
  EXPECT_EQ(fit.informative, 8U);
  expect_near(fit.abilities, {std::log(3.0) / 2, -std::log(3.0) / 2}, 1e-9);
  const double error = std::sqrt(1 / 6.0 + 1 / 2.0) / 2;
  expect_near(fit.standard_errors, {error, error}, 1e-9);
}

TEST(Rasch, DoesNotDependOnTheOrderOfScenariosAndHalvesErrorsWithFourTimesAsMany) {
  const OutcomeMatrix once = made(3, 200, 1);
  OutcomeMatrix four;
  for (int i = 0; i < 4; ++i) four.insert(four.end(), once.rbegin(), once.rend());
  const RaschFit a = fit_rasch(once), b = fit_rasch(four);
  expect_near(b.abilities, a.abilities, 1e-8);
  for (std::size_t i = 0; i < a.abilities.size(); ++i)
    EXPECT_NEAR(b.standard_errors[i], a.standard_errors[i] / 2, 1e-8);
}

TEST(Rasch, RecoversTheAbilitiesOf64Methods) {
  // Abilities of -6.3 to 6.3 in steps of 0.2. With 4,000 scenarios the largest of 64 deviations is
  // below 4.5 standard errors with a probability of 1 - 64 x 6.8e-6.
  Lcg uniform(5);
  OutcomeMatrix outcomes;
  for (int i = 0; i < 4000; ++i) {
    const double difficulty = 14 * uniform() - 7;
    outcomes.emplace_back();
    for (int method = 0; method < 64; ++method) {
      const double z = 0.2 * method - 6.3 - difficulty;
      outcomes.back().push_back(uniform() < 1 / (1 + std::exp(-z)));
    }
  }
  ASSERT_EQ(comparable_methods(outcomes).size(), 64U);
  const RaschFit fit = fit_rasch(outcomes);
  for (std::size_t i = 0; i < 64; ++i) {
    EXPECT_LT(std::abs(fit.abilities[i] - (0.2 * static_cast<double>(i) - 6.3)),
              4.5 * fit.standard_errors[i])
        << i;
    EXPECT_LT(fit.standard_errors[i], 0.1);
  }
}

TEST(Rasch, SetsMethodsAsideWhoseAbilityHasNoFiniteEstimate) {
  // The first solves all, the last none; the two between are better once each.
  const OutcomeMatrix outcomes = {{true, true, false, false}, {true, false, true, false}};
  EXPECT_EQ(comparable_methods(outcomes), (std::vector<std::size_t>{1, 2}));
  // Two pairs: 0 and 1 solve what 2 and 3 fail, never the reverse.
  const OutcomeMatrix parted = {{true, false, false, false},
                                {false, true, false, false},
                                {true, true, true, false},
                                {true, true, false, true}};
  EXPECT_EQ(comparable_methods(parted), (std::vector<std::size_t>{0, 1}));
  // An order without exceptions: each method alone.
  EXPECT_EQ(comparable_methods({{true, false}, {true, false}}).size(), 1U);
  EXPECT_TRUE(comparable_methods({}).empty());
}

TEST(Rasch, AndersensTestNeedsMethodsThatAreComparableInBothGroups) {
  EXPECT_FALSE(andersen_test({{true, false}, {false, true}, {true, true}}));
  EXPECT_FALSE(andersen_test({}));
}

TEST(Rasch, DifficultyFallsWithTheNumberOfSolversAndIsFiniteForAllOfThem) {
  // Two methods of ability 0, p = 1 / (1 + exp(d)): Warm's estimate adds (1 - 2 p) / 2 to the sum
  // of residuals s - 2 p, which is 0 at p = (s + 1/2) / 3: d = log(5), 0, -log(5) for s = 0, 1, 2.
  expect_near(difficulties_by_solvers({0, 0}), {std::log(5.0), 0, -std::log(5.0)}, 1e-9);
}

}  // namespace
}  // namespace slalom
