// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "result_fixture.h"

#include <slalom/analysis/decision_rule.h>
#include <slalom/core/error.h>
#include <slalom/core/random.h>

#include <boost/math/distributions/normal.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

namespace slalom {
namespace {

/// Rules about metrics in [0, 1], except the time.
DecisionRule parse(const std::string& text) {
  return parse_decision_rule(text, [](const std::string& metric) {
    return metric == "time_to_goal" ? Range::at_least(0)
           : metric == "score"      ? Range::between(-2, 0.5)
                                    : Range::between(0, 1);
  });
}

const DecisionRule kDecided = parse("compare(success, mine, nd) decided");
const DecisionRule kNoWorse = parse("compare(success, mine, nd) no worse than 0.05");

TEST(DecisionRule, IsParsed) {
  EXPECT_EQ(kDecided.metric, "success");
  EXPECT_EQ(kDecided.method, "mine");
  EXPECT_EQ(kDecided.reference, "nd");
  EXPECT_EQ(kDecided.relevant, 0.05);
  EXPECT_EQ(kDecided.question, DecisionRule::Question::Difference);
  EXPECT_FALSE(kDecided.in_pool);
  EXPECT_EQ(parse(" compare( spl ,a,b )decided  within 0.1 ").relevant, 0.1);
  EXPECT_EQ(kNoWorse.question, DecisionRule::Question::NoWorse);
  EXPECT_EQ(parse("compare(success,a,b) no worse than 0.02").relevant, 0.02);
  const DecisionRule pool = parse("compare(success, a, b) decided within 0.1  in the pool");
  EXPECT_TRUE(pool.in_pool);
  EXPECT_EQ(pool.relevant, 0.1);
  EXPECT_TRUE(parse("compare(success, a, b) no worse than 0.1 in the pool").in_pool);
  EXPECT_EQ(parse("compare(time_to_goal, a, b) decided in more scenarios").question,
            DecisionRule::Question::Majority);  // of signs: the metric needs no bounds
}

TEST(DecisionRule, ThatIsMalformedIsRejectedWithTheExpectedForm) {
  for (const char* text :
       {"compare", "compare(success, mine) decided", "compare(success, mine, nd)",
        "compare(success, mine, nd) decided within x",
        "compare(success, mine, nd) decided within 0",
        "compare(success, mine, nd) no worse than -1", "compare(success, a, b) decided in density",
        "compare(success, a, b) decided in more scenarios in the pool"})
    EXPECT_TRUE(throws_error(ErrorKind::Usage, "--until",
                             {"compare(METRIC, METHOD, REFERENCE) decided"}, [&] { parse(text); }))
        << text;
}

TEST(DecisionRule, RefusesMetricsWithoutBoundsAndDifferencesThatCannotBe) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--until",
                           {"'time_to_goal' is not bounded", "success"},
                           [] { parse("compare(time_to_goal, a, b) decided"); }));
  EXPECT_EQ(parse("compare(score, a, b) decided within 2.4").bound, 2.5);  // of a difference
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--until", {"less than 2.5"},
                           [] { parse("compare(score, a, b) decided within 2.5"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--until", {"less than 1"},
                           [] { parse("compare(success, a, b) decided within 1"); }));
}

TEST(Decision, IsMadeByEqualResultsOnlyForNoRelevantDifference) {
  const std::vector<double> equal(1000, 0.0);
  const DecisionState state = decide(kDecided, equal, 0.95);
  EXPECT_EQ(state.decision, Decision::NoRelevantDifference);
  EXPECT_LT(state.scenarios, 1000U);
  EXPECT_LE(state.p, 0.05);
  EXPECT_EQ(decide(kNoWorse, equal, 0.95).decision, Decision::NoWorse);
  EXPECT_EQ(decide(kDecided, {}, 0.95).decision, Decision::Open);
}

TEST(Decision, IsNotChangedByWhatComesAfterIt) {
  std::vector<double> advantages(60, 1.0);
  const DecisionState state = decide(kDecided, advantages, 0.95);
  EXPECT_EQ(state.decision, Decision::Better);
  ASSERT_LT(state.scenarios, 60U);
  advantages.insert(advantages.end(), 500, -1.0);
  EXPECT_EQ(decide(kDecided, advantages, 0.95).scenarios, state.scenarios);
  EXPECT_EQ(decide(kDecided, std::vector<double>(60, -1.0), 0.95).decision, Decision::Worse);
  EXPECT_EQ(decide(kNoWorse, std::vector<double>(60, -1.0), 0.95).decision, Decision::Worse);
}

/// A campaign of two methods whose successes differ in a fraction `different` of the scenarios and
/// by `advantage` in the mean.
std::vector<double> made_up_campaign(RandomEngine& engine, double different, double advantage,
                                     std::size_t scenarios) {
  std::vector<double> advantages;
  for (std::size_t i = 0; i < scenarios; ++i) {
    const double u = uniform_real(engine, 0, 1);
    advantages.push_back(u < (different + advantage) / 2 ? 1 : u < different ? -1 : 0);
  }
  return advantages;
}

struct Simulated {
  double better = 0, worse = 0, equal = 0;  ///< fractions of campaigns
  double scenarios = 0;                     ///< mean
};

constexpr int kCampaigns = 1000;

Simulated simulate(const DecisionRule& rule, double different, double advantage, std::size_t pool) {
  RandomEngine engine(7);
  Simulated result;
  for (int i = 0; i < kCampaigns; ++i) {
    const DecisionState state =
        decide(rule, made_up_campaign(engine, different, advantage, pool), 0.95);
    result.better += state.decision == Decision::Better || state.decision == Decision::NoWorse;
    result.worse += state.decision == Decision::Worse;
    result.equal += state.decision == Decision::NoRelevantDifference;
    result.scenarios += static_cast<double>(state.scenarios);
  }
  for (double* value : {&result.better, &result.worse, &result.equal, &result.scenarios})
    *value /= kCampaigns;
  return result;
}

/// Pairs of a test of a fixed size, at 0.05 two-sided, with this power.
double fixed_size(double different, double advantage, double power) {
  const boost::math::normal normal;
  const double z = quantile(normal, 0.975) + quantile(normal, power);
  return z * z * (different - advantage * advantage) / (advantage * advantage);
}

// Three standard errors of 1,000 campaigns above 0.05.
constexpr double kMaxErrors = 0.05 + 3 * 0.0069;

TEST(Decision, IsWrongInAtMostFivePercentOfCampaignsWithoutADifference) {
  for (const double different : {0.1, 0.4}) {
    const Simulated result = simulate(kDecided, different, 0, 6000);
    EXPECT_LE(result.better + result.worse, kMaxErrors) << different;
    EXPECT_GE(result.equal, 0.9) << different;
  }
}

TEST(Decision, TakesAtMostSeventyPercentOfTheRunsOfAFixedSizeAndFarFewerForLargerDifferences) {
  for (const double different : {0.1, 0.4}) {
    const Simulated at_relevant = simulate(kDecided, different, 0.05, 6000);
    EXPECT_GE(at_relevant.better, 0.9);
    EXPECT_LE(at_relevant.worse + at_relevant.equal, kMaxErrors);
    const double fixed = fixed_size(different, 0.05, at_relevant.better);
    EXPECT_LE(at_relevant.scenarios, 0.7 * fixed) << different;
    const Simulated twice = simulate(kDecided, different, 0.1, 6000);
    EXPECT_GE(twice.better, 0.99);
    EXPECT_LE(twice.scenarios, 0.3 * fixed) << different;
  }
}

TEST(Decision, ThatAMethodIsNoWorseIsWrongInAtMostFivePercentAtTheMargin) {
  EXPECT_LE(simulate(kNoWorse, 0.2, -0.05, 3000).better, kMaxErrors);
  EXPECT_GE(simulate(kNoWorse, 0.2, 0, 3000).better, 0.9);
  EXPECT_GE(simulate(kNoWorse, 0.2, -0.1, 3000).worse, 0.9);
}

/// A pool of 300 scenarios in random order, of which 60 differ; the mean is exactly 0.
std::vector<double> pool_without_a_difference(std::mt19937_64& engine) {
  std::vector<double> values(300, 0);
  for (std::size_t i = 0; i < 60; ++i) values[i] = i % 2 == 0 ? 1 : -1;
  std::shuffle(values.begin(), values.end(), engine);
  return values;
}

TEST(Decision, AboutAPoolIsWrongInAtMostFivePercentAndKnowsTheMeanAtItsEnd) {
  std::mt19937_64 engine(11);
  const DecisionRule rule = parse("compare(success, mine, nd) decided in the pool");
  double wrong = 0;
  for (int i = 0; i < kCampaigns; ++i) {
    const DecisionState state = decide(rule, pool_without_a_difference(engine), 0.95, 300);
    wrong += state.decision == Decision::Better || state.decision == Decision::Worse;
    EXPECT_NE(state.decision, Decision::Open);
  }
  EXPECT_LE(wrong / kCampaigns, kMaxErrors);
  // One success more in 300 scenarios is known when all have been run.
  std::vector<double> values(300, 0);
  values[120] = 1;
  EXPECT_EQ(decide({"success", "a", "b", 1e-4, DecisionRule::Question::Difference, 1, true}, values,
                   0.95, 300)
                .decision,
            Decision::Better);
}

TEST(Decision, AboutAPoolNeedsFewerScenariosThanAboutWhatItIsASampleOf) {
  RandomEngine engine(12);
  const DecisionRule sample = parse("compare(success, mine, nd) decided");
  DecisionRule pool = sample;
  pool.in_pool = true;
  int by_sample = 0, by_pool = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<double> values = made_up_campaign(engine, 0.2, 0.1, 300);
    by_sample +=
        decide(sample, {values.begin(), values.begin() + 150}, 0.95).decision == Decision::Better;
    by_pool += decide(pool, {values.begin(), values.begin() + 150}, 0.95, 300).decision ==
               Decision::Better;
  }
  EXPECT_GE(by_pool, by_sample + 20);
}

TEST(Decision, InMoreScenariosCountsThoseInWhichTheMethodsDiffer) {
  const DecisionRule rule = parse("compare(spl, mine, nd) decided in more scenarios");
  // A small gain in many scenarios, a large loss in few: the mean is worse, the majority better.
  std::vector<double> advantages;
  for (int i = 0; i < 400; ++i) advantages.push_back(i % 4 == 3 ? -0.9 : i % 4 == 2 ? 0 : 0.05);
  const DecisionState state = decide(rule, advantages, 0.95);
  EXPECT_EQ(state.decision, Decision::Better);
  EXPECT_EQ(state.better + state.worse + state.scenarios / 4, state.scenarios);
  EXPECT_LT(state.advantage, 0);
  EXPECT_EQ(decide(kDecided, advantages, 0.95).decision, Decision::Worse);
  EXPECT_EQ(decide(rule, std::vector<double>(1000, 0), 0.95).decision, Decision::Open);
  RandomEngine engine(13);
  double wrong = 0;
  for (int i = 0; i < kCampaigns; ++i)
    wrong += decide(rule, made_up_campaign(engine, 0.3, 0, 1000), 0.95).decision != Decision::Open;
  EXPECT_LE(wrong / kCampaigns, kMaxErrors);
}

TEST(ScenarioAdvantages, ArePairedAndInTheOrderOfTheHashes) {
  ResultFixture fixture;
  std::vector<std::string> hashes;
  for (const double mine : {1.0, -1.0, 1.0}) {  // -1: no success
    const auto scenario = fixture.add_scenario(Value::of(0.1));
    fixture.add_run(scenario, "mine", mine);
    fixture.add_run(scenario, "nd", hashes.size() == 2 ? 1.0 : -1.0);
    hashes.push_back(fixture.table.scenario_hashes.back());
  }
  EXPECT_EQ(scenario_advantages(fixture.table, kDecided, hashes), (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(scenario_advantages(fixture.table, kDecided, {hashes[2], hashes[0], "unknown"}),
            (std::vector<double>{0, 1}));
  DecisionRule unknown = kDecided;
  unknown.method = "mien";
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "", {"mien", "'mine'"},
                           [&] { scenario_advantages(fixture.table, unknown, hashes); }));
}

TEST(DecisionSentence, SaysWhatIsKnown) {
  EXPECT_EQ(
      decision_sentence(kDecided, {Decision::Better, 46, 0.217, 0.019}),
      "mine is better than nd in success: mean advantage +0.217 over 46 scenarios, p = 0.0190");
  EXPECT_EQ(
      decision_sentence(kNoWorse, {Decision::NoWorse, 90, -0.01, 0.04}),
      "mine is not worse than nd by 0.05 in success: mean advantage -0.010 over 90 scenarios, "
      "p = 0.0400");
  EXPECT_EQ(decision_sentence(kDecided, {Decision::Open, 9, 0, 1}),
            "not decided between mine and nd in success: mean advantage +0.000 over 9 scenarios");
  DecisionRule rule = kDecided;
  rule.in_pool = true;
  EXPECT_EQ(decision_sentence(rule, {Decision::Worse, 60, -0.1, 0.02}),
            "mine is worse than nd in success in this pool: mean advantage -0.100 over 60 "
            "scenarios, p = 0.0200");
  const DecisionRule more = parse("compare(spl, mine, nd) decided in more scenarios");
  EXPECT_EQ(decision_sentence(more, {Decision::Better, 60, 0.1, 0.02, 30, 10}),
            "mine is better than nd in spl in more scenarios: better in 30 and worse in 10 of 60 "
            "scenarios, p = 0.0200");
}

TEST(DecisionRule, ADecisionNeverContradictsTheMeanThatIsShown) {
  // An order from bad to good scenarios, in which each of both tests rejects in its own part.
  std::vector<double> advantages(60, -1);
  advantages.insert(advantages.end(), 300, 0.5);
  for (const bool no_worse : {false, true}) {
    const DecisionRule rule{
        "success", "a", "b", 0.05,
        no_worse ? DecisionRule::Question::NoWorse : DecisionRule::Question::Difference};
    for (std::size_t n = 1; n <= advantages.size(); ++n) {
      const DecisionState state = decide(
          rule, {advantages.begin(), advantages.begin() + static_cast<std::ptrdiff_t>(n)}, 0.95);
      const double mean = state.advantage, d = 0.05;
      const std::map<Decision, bool> consistent = {
          {Decision::Better, mean > 0},
          {Decision::Worse, mean < (no_worse ? -d : 0)},
          {Decision::NoWorse, mean > -d},
          {Decision::NoRelevantDifference, std::abs(mean) < d},
          {Decision::Open, true}};
      EXPECT_TRUE(consistent.at(state.decision)) << mean;
    }
  }
}

}  // namespace
}  // namespace slalom
