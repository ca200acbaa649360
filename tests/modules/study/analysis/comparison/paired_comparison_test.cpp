// SPDX-License-Identifier: BSD-3-Clause
#include "result_fixture.h"

#include <slalom/analysis/gate.h>
#include <slalom/analysis/paired_comparison.h>
#include <slalom/core/error.h>
#include <slalom/core/random.h>
#include <slalom/statistics/mean_interval.h>
#include <slalom/statistics/paired_rates.h>
#include <slalom/statistics/power.h>
#include <slalom/statistics/rank_statistics.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

/// Method a succeeds in the first `both + only_a` of n scenarios, b in `both` and the next
/// `only_b`.
ResultTable rates(int n, int both, int only_a, int only_b) {
  ResultFixture fixture;
  for (int i = 0; i < n; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    const bool a = i < both + only_a;
    const bool b = i < both || (i >= both + only_a && i < both + only_a + only_b);
    fixture.add_run(hash, "a", a ? 0.9 : -1);
    fixture.add_run(hash, "b", b ? 0.9 : -1);
  }
  return fixture.table;
}

/// Optimality of b is that of a and `shift` more, with noise of deviation `sigma`.
ResultTable shifted(int n, double shift, double sigma) {
  RandomEngine engine(3);
  ResultFixture fixture;
  for (int i = 0; i < n; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    const double a = uniform_real(engine, 0.4, 0.6);
    fixture.add_run(hash, "a", a);
    fixture.add_run(hash, "b", a + shift + normal(engine, 0, sigma));
  }
  return fixture.table;
}

PairedComparison only(const ResultTable& table, const std::string& metric) {
  const auto family = compare_methods(table, {metric}, "", {});
  EXPECT_EQ(family.size(), 1u);
  return family.at(0);
}

TEST(PairedComparison, CountsDiscordantScenariosOfRates) {
  const PairedComparison c = only(rates(60, 40, 2, 14), "success");
  EXPECT_EQ(c.scenarios, 60u);
  EXPECT_EQ(c.higher, 14u);
  EXPECT_EQ(c.lower, 2u);
  EXPECT_EQ(c.test, PairedComparison::Test::McNemarExact);
  EXPECT_DOUBLE_EQ(c.p, mcnemar_exact(14, 2));
  EXPECT_NEAR(*c.difference, 12 / 60.0, 1e-12);
  EXPECT_EQ(c.verdict, Verdict::Better);
  EXPECT_NE(verdict_sentence(c).find("b is better than a in success: 0.900 against 0.700"),
            std::string::npos)
      << verdict_sentence(c);
}

TEST(PairedComparison, EstimatesTheRequiredNumberOfScenarios) {
  const PairedComparison c = only(rates(10, 6, 1, 2), "success");
  EXPECT_EQ(c.verdict, Verdict::NotEnough);
  // Three of ten differ, plus one added: variance 4 / 11; divided by Wilcoxon's efficiency 3 / pi.
  const double pairs = static_cast<double>(required_pairs(0.05, std::sqrt(4.0 / 11), 0.05, 0.8));
  EXPECT_EQ(c.required_scenarios, static_cast<std::size_t>(std::ceil(pairs * M_PI / 3)));
  const std::string more = std::to_string(c.required_scenarios - 10) + " more scenarios";
  EXPECT_NE(verdict_sentence(c).find(more), std::string::npos) << verdict_sentence(c);
}

TEST(PairedComparison, RequiresOfOneScenarioNoFewerThanOfTwo) {
  // One differs, plus one added, in 1 + 1 scenarios: variance 1.
  const PairedComparison c = only(rates(1, 0, 1, 0), "success");
  const double pairs = static_cast<double>(required_pairs(0.05, 1, 0.05, 0.8));
  EXPECT_EQ(c.required_scenarios, static_cast<std::size_t>(std::ceil(pairs * M_PI / 3)));
}

TEST(PairedComparison, DoesNotPlanWithTheUnknownDeviationOfOneScenario) {
  const PairedComparison c = only(shifted(1, 0.1, 0), "optimality");
  EXPECT_EQ(c.verdict, Verdict::NotEnough);
  EXPECT_EQ(verdict_sentence(c).find("more scenarios"), std::string::npos) << verdict_sentence(c);
}

TEST(PairedComparison, DoesNotAskForMoreScenariosThanAnybodyRuns) {
  PairedComparison c = only(rates(10, 6, 1, 2), "success");
  c.required_scenarios = 394500;  // 5 % of a mean near 0
  EXPECT_NE(verdict_sentence(c).find("would require more than 100000 scenarios"), std::string::npos)
      << verdict_sentence(c);
}

TEST(PairedComparison, ReportsNoDifferenceOnlyWithSufficientPower) {
  const PairedComparison same = only(shifted(60, 0, 0.01), "optimality");
  EXPECT_EQ(same.verdict, Verdict::NoDifference);
  EXPECT_GE(same.scenarios, same.required_scenarios);
  EXPECT_EQ(only(shifted(60, 0, 0.1), "optimality").verdict, Verdict::NotEnough);
}

TEST(PairedComparison, EqualValuesAreIdenticalAndNotInTheFamily) {
  ResultFixture fixture;
  for (int i = 0; i < 12; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    fixture.add_run(hash, "a", 0.5 + 0.01 * i);
    fixture.add_run(hash, "b", 0.5 + 0.01 * i);
    fixture.add_run(hash, "c", 0.7 + 0.01 * i);
  }
  const auto family = compare_methods(fixture.table, {"optimality"}, "", {});
  ASSERT_EQ(family.size(), 3u);
  EXPECT_EQ(family[0].verdict, Verdict::Identical);
  EXPECT_EQ(verdict_sentence(family[0]),
            "b and a are identical in optimality: equal values in 12 pairs of runs over 12 "
            "scenarios");
  // Twelve differences of one sign, in a family of two: c with a and with b.
  EXPECT_DOUBLE_EQ(family[1].adjusted_p, 2 * 2.0 / 4096);
  EXPECT_EQ(family[1].family, 2u);
}

TEST(PairedComparison, WithoutACommonPairIsNotATestOfTheFamily) {
  ResultFixture fixture;
  for (int i = 0; i < 12; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    fixture.add_run(hash, "a", 0.5 + 0.01 * i);
    fixture.add_run(hash, "b", 0.7 + 0.01 * i);
    fixture.add_run(hash, "c", -1);  // fails, so that its optimality is missing
  }
  const auto family = compare_methods(fixture.table, {"optimality"}, "", {});
  ASSERT_EQ(family.size(), 3u);
  // Twelve differences of one sign between a and b, the only test.
  EXPECT_DOUBLE_EQ(family[0].adjusted_p, 2.0 / 4096);
  for (const auto& c : {family[1], family[2]}) {
    EXPECT_EQ(c.scenarios, 0u);
    EXPECT_EQ(c.family, 1u);
    EXPECT_EQ(c.verdict, Verdict::NotEnough);
  }
}

TEST(PairedComparison, WithoutACommonScenarioDoesNotEndTheOthers) {
  ResultFixture fixture;
  for (int i = 0; i < 12; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    fixture.add_run(hash, "a", 0.5 + 0.01 * i);
    fixture.add_run(hash, "b", 0.7 + 0.01 * i);
    fixture.add_run(fixture.add_scenario(Value::of(0.1)), "c", 0.9);
  }
  const auto family = compare_methods(fixture.table, {"optimality"}, "", {});
  ASSERT_EQ(family.size(), 3u);
  EXPECT_DOUBLE_EQ(family[0].adjusted_p, 2.0 / 4096);  // a and b, the only test
  for (const auto& c : {family[1], family[2]}) {
    EXPECT_FALSE(c.has_partners());
    EXPECT_EQ(c.verdict, Verdict::NotEnough);
    EXPECT_EQ(verdict_sentence(c), "not enough runs to compare c with " + c.a +
                                       " in optimality: no common scenario and repetition");
  }
  const auto columns = resolve_columns(fixture.table, {"optimality"});
  EXPECT_EQ(directed_comparisons(fixture.table, columns, {}).size(), 6u);  // and in success
  EXPECT_THROW(compare_methods(fixture.table, {"optimality"}, "c", {}), Error);
}

/// The methods succeed in the first scenarios of their own, of n.
ResultTable separate(int n, int a, int b) {
  ResultFixture fixture;
  for (int i = 0; i < n; ++i) {
    fixture.add_run(fixture.add_scenario(Value::of(0.1)), "a", i < a ? 0.5 + 0.01 * i : -1);
    fixture.add_run(fixture.add_scenario(Value::of(0.1)), "b", i < b ? 0.7 + 0.01 * i : -1);
  }
  return fixture.table;
}

ComparisonOptions unpaired() {
  ComparisonOptions options;
  options.unpaired = true;
  return options;
}

TEST(UnpairedComparison, RatesHaveFishersTestAndNewcombesInterval) {
  const PairedComparison c = compare_methods(separate(15, 1, 15), {"success"}, "", unpaired())[0];
  EXPECT_TRUE(c.is_unpaired);
  EXPECT_EQ(c.test, PairedComparison::Test::FisherExact);
  EXPECT_NEAR(c.p, 2.062952e-7, 1e-12);  // fisher.test() of R
  EXPECT_NEAR(*c.difference, 14 / 15.0, 1e-12);
  // Newcombe's method 10 from the Wilson intervals [0.0119, 0.2982] and [0.7961, 1].
  EXPECT_NEAR(c.interval->low, 14 / 15.0 - std::hypot(1 - 0.79612, 0.29817 - 1 / 15.0), 1e-4);
  EXPECT_NEAR(c.interval->high, 14 / 15.0 + std::hypot(0, 1 / 15.0 - 0.01187), 1e-4);
  EXPECT_EQ(c.verdict, Verdict::Better);
  EXPECT_NE(
      verdict_sentence(c).find("over 15 and 15 unpaired scenarios, p < 0.0001 (Fisher's exact "
                               "test, Holm over 1 pair)"),
      std::string::npos)
      << verdict_sentence(c);
}

TEST(UnpairedComparison, AmountsHaveTheRankSumTest) {
  const PairedComparison c =
      compare_methods(separate(15, 12, 9), {"optimality"}, "", unpaired())[0];
  EXPECT_EQ(c.test, PairedComparison::Test::RankSumExact);
  EXPECT_EQ(c.scenarios_a, 12u);
  EXPECT_EQ(c.scenarios_b, 9u);
  EXPECT_EQ(c.runs_without_value, 9u);
  EXPECT_EQ(c.verdict, Verdict::Better);
  EXPECT_EQ(*c.superiority, 1) << "0.7 and more against 0.61 at most";
}

TEST(UnpairedComparison, SaysHowManyAreMissing) {
  const PairedComparison c = compare_methods(separate(5, 2, 4), {"success"}, "", unpaired())[0];
  EXPECT_EQ(c.verdict, Verdict::NotEnough);
  // Rates of 2.5 and 4.5 in 6; a t test of the difference of one of each, over its efficiency.
  const double variance = 2.5 * 3.5 / 36 + 4.5 * 1.5 / 36;
  const double pairs = static_cast<double>(required_pairs(0.05, std::sqrt(variance), 0.05, 0.8));
  EXPECT_EQ(c.required_scenarios, static_cast<std::size_t>(std::ceil(pairs * M_PI / 3)));
  EXPECT_NE(verdict_sentence(c).find(" more scenarios of each required"), std::string::npos)
      << verdict_sentence(c);
  const PairedComparison none =
      compare_methods(separate(5, 2, 0), {"optimality"}, "", unpaired())[0];
  EXPECT_EQ(verdict_sentence(none),
            "not enough runs to compare b with a in optimality: no values (8 runs without)");
}

TEST(UnpairedComparison, IsMadeOnlyIfAllowedAndIfNothingPairs) {
  EXPECT_THROW(compare_methods(separate(5, 2, 4), {"success"}, "", {}), Error);
  EXPECT_FALSE(compare_methods(rates(9, 3, 2, 1), {"success"}, "", unpaired())[0].is_unpaired);
}

TEST(UnpairedComparison, RepetitionsOfAScenarioAreNotIndependent) {
  ResultFixture fixture;
  for (int i = 0; i < 6; ++i) {
    const std::string a = fixture.add_scenario(Value::of(0.1));
    const std::string b = fixture.add_scenario(Value::of(0.1));
    for (int repetition = 0; repetition < 10; ++repetition) {
      fixture.add_run(a, "a", i < 3 ? 0.5 : -1, repetition);
      fixture.add_run(b, "b", 0.5, repetition);
    }
  }
  const PairedComparison c = compare_methods(fixture.table, {"success"}, "", unpaired())[0];
  EXPECT_EQ(c.scenarios_a, 6u);
  EXPECT_EQ(c.test, PairedComparison::Test::RankSumExact);
  EXPECT_GT(c.p, 0.05);
}

/// Both methods' values of a metric, by scenario.
ResultTable pairs_of(const QuantityInfo& info, const std::vector<double>& a,
                     const std::vector<double>& b) {
  ResultFixture fixture;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    fixture.add_run(hash, "a", 0.5);
    fixture.add_run(hash, "b", 0.5);
  }
  ResultTable table = std::move(fixture.table);
  ValueColumn& values = table.metrics.emplace_back(info);
  for (std::size_t i = 0; i < a.size(); ++i) {
    values.add_number(a[i]);
    values.add_number(b[i]);
  }
  return table;
}

TEST(PairedComparison, OfTimesHasTheRatioOfGeometricMeans) {
  const QuantityInfo time{
      "time", 1, "Time", "s", Direction::Down, QuantityKind::Amount, Range::at_least(0)};
  RandomEngine engine(41);
  std::vector<double> a, b, logs;
  for (int i = 0; i < 30; ++i) {
    a.push_back(std::exp(normal(engine, 3, 0.5)));
    b.push_back(a.back() * std::exp(normal(engine, -0.2, 0.1)));
    logs.push_back(std::log(b.back() / a.back()));
  }
  const PairedComparison c = only(pairs_of(time, a, b), "time");
  EXPECT_FALSE(c.interval) << "a mean without a bound has none";
  EXPECT_NEAR(*c.ratio, std::exp(mean(logs)), 1e-12);
  const auto t = t_interval(moments_of({logs, std::vector<double>(30, 1.0)}), 0.95);
  EXPECT_NEAR(c.ratio_interval->low, std::exp(t->low), 1e-12);
  EXPECT_NEAR(c.ratio_interval->high, std::exp(t->high), 1e-12);
  EXPECT_EQ(c.verdict, Verdict::Better);
  EXPECT_NE(verdict_sentence(c).find(", ratio of geometric means 0.8"), std::string::npos)
      << verdict_sentence(c);
}

TEST(PairedComparison, OfValuesThatAreNotPositiveHasTheShift) {
  const QuantityInfo clearance{"clearance", 1, "Clearance", "m", Direction::Up};
  RandomEngine engine(42);
  std::vector<double> a, b;
  for (int i = 0; i < 30; ++i) {
    a.push_back(normal(engine, 0, 0.5));
    b.push_back(a.back() + normal(engine, 0.2, 0.1));
  }
  const PairedComparison c = only(pairs_of(clearance, a, b), "clearance");
  EXPECT_FALSE(c.interval || c.ratio);
  EXPECT_EQ(c.verdict, Verdict::Better);
  EXPECT_NE(verdict_sentence(c).find(", shift 0."), std::string::npos) << verdict_sentence(c);
}

TEST(PairedComparison, OfScoresCombinesTheHurdleIntervalsOfBothSides) {
  const QuantityInfo score{
      "score", 1, "Score", "-", Direction::Up, QuantityKind::Score, Range::between(0, 1)};
  const std::vector<double> a = {0.9, 0.8, 0, 0.85, 0.95, 0.9, 0, 0.8},
                            b = {0.9, 0.7, 0.9, 0.8, 0.9, 0.9, 0, 0.7}, ones(8, 1.0);
  const auto hurdle = [&](const std::vector<double>& values) {
    std::vector<double> positives;
    for (const double value : values) positives.push_back(value > 0 ? 1 : 0);
    return hurdle_interval(score_moments({values, ones}, positives), 1, 0.95);
  };
  const PairedComparison c = only(pairs_of(score, a, b), "score");
  const Interval expected =
      difference_interval(mean(b), hurdle(b), mean(a), hurdle(a), pearson(a, b).value_or(0));
  EXPECT_NEAR(c.interval->low, expected.low, 1e-12);
  EXPECT_NEAR(c.interval->high, expected.high, 1e-12);
}

TEST(PairedComparison, EqualMeansOfDifferentRepetitionsAreNotIdentical) {
  ResultFixture fixture;
  const std::string hash = fixture.add_scenario(Value::of(0.1));
  for (const int repetition : {0, 1}) {
    fixture.add_run(hash, "a", repetition == 0 ? 0.25 : 0.75, repetition);
    fixture.add_run(hash, "b", repetition == 0 ? 0.75 : 0.25, repetition);
  }
  const PairedComparison c = only(fixture.table, "optimality");
  EXPECT_EQ(c.equal, 1u);
  EXPECT_NE(c.verdict, Verdict::Identical);
}

TEST(PairedComparison, SayWhyAnIntervalWithoutZeroIsNotConfirmed) {
  // p = 2 * (1 + 9) / 2^9 = 0.039 alone, not in a family of two.
  const ResultTable table = rates(40, 20, 8, 1);
  const PairedComparison alone = only(table, "success");
  EXPECT_DOUBLE_EQ(alone.p, 20.0 / 512);
  EXPECT_EQ(alone.verdict, Verdict::Worse);
  std::vector<PairedComparison> family = {alone, alone};
  finish_families(family);
  EXPECT_EQ(family[0].verdict, Verdict::Unconfirmed);
  EXPECT_LT(family[0].interval->high, 0);
  const std::string sentence = verdict_sentence(family[0]);
  EXPECT_NE(sentence.find("the interval excludes 0, but the test does not reject equality after "
                          "the correction (before: p = 0.0391)"),
            std::string::npos)
      << sentence;
  EXPECT_NE(sentence.find("p = 0.0781 (exact McNemar test, Holm over 2 pairs);"), std::string::npos)
      << sentence;
}

/// Twelve scenarios: c is better than b, and b than a, in each.
ResultTable three_in_order() {
  ResultFixture fixture;
  for (int i = 0; i < 12; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    fixture.add_run(hash, "a", i < 6 ? 0.3 + 0.01 * i : -1);
    fixture.add_run(hash, "b", i < 11 ? 0.5 + 0.02 * i : -1);
    fixture.add_run(hash, "c", 0.7 + 0.02 * i);
  }
  return fixture.table;
}

TEST(PairedComparison, OfOneMetricAreAFamilyWhateverElseIsCompared) {
  const ResultTable table = three_in_order();
  const auto alone = compare_methods(table, {"success"}, "", {});
  const auto among = compare_methods(table, {"optimality", "success", "path_length"}, "", {});
  const auto of_b = compare_methods(table, {"success", "optimality"}, "", {}, "b");
  ASSERT_EQ(among.size(), 9u);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(among[3 + i].adjusted_p, alone[i].adjusted_p);
    EXPECT_EQ(verdict_sentence(among[3 + i]), verdict_sentence(alone[i]));
  }
  ASSERT_EQ(of_b.size(), 4u);
  EXPECT_EQ(verdict_sentence(of_b[0]), verdict_sentence(alone[0])) << "a and b";
  EXPECT_EQ(verdict_sentence(of_b[1]), verdict_sentence(alone[2])) << "b and c";
  EXPECT_NE(verdict_sentence(alone[0]).find(" (exact McNemar test, Holm over 3 pairs)"),
            std::string::npos)
      << verdict_sentence(alone[0]);
}

TEST(PairedComparison, WithABaselineAreAFamilyOfTheirOwnAndSaySo) {
  const ResultTable table = three_in_order();
  const auto all = compare_methods(table, {"success"}, "", {});
  const auto against_a = compare_methods(table, {"success"}, "a", {});
  // Six scenarios that only c solves, five that only b solves: 2 / 2^6 and 2 / 2^5.
  EXPECT_DOUBLE_EQ(all[1].adjusted_p, 3 * 2.0 / 64);
  EXPECT_DOUBLE_EQ(against_a[1].adjusted_p, 2 * 2.0 / 64);
  EXPECT_NE(verdict_sentence(against_a[1]).find("Holm over 2 pairs with a)"), std::string::npos)
      << verdict_sentence(against_a[1]);
}

TEST(PairedComparison, OfTwoResultsKeepTheirFamilyWithAMethod) {
  ResultTable before = three_in_order(), after;
  ResultFixture better;
  for (int i = 0; i < 12; ++i) {
    const std::string hash = better.add_scenario(Value::of(0.1));
    for (const char* method : {"a", "b", "c"}) better.add_run(hash, method, 0.99 - 0.001 * i);
  }
  after = better.table;
  before.source = "before";
  after.source = "after";
  const auto all = compare_results(before, after, {"optimality", "success"}, {});
  const auto of_b = compare_results(before, after, {"optimality", "success"}, {}, "b");
  ASSERT_EQ(all.size(), 6u);
  ASSERT_EQ(of_b.size(), 2u);
  EXPECT_EQ(of_b[0].family, 3u);
  EXPECT_EQ(verdict_sentence(of_b[0]), verdict_sentence(all[1]));
  EXPECT_EQ(verdict_sentence(of_b[1]), verdict_sentence(all[4]));
}

TEST(PairedComparison, FollowsTheDirectionOfTheMetric) {
  const PairedComparison up = only(shifted(30, -0.2, 0.01), "optimality");
  EXPECT_EQ(up.verdict, Verdict::Worse);
  EXPECT_NEAR(up.shift->estimate, -0.2, 0.01);
  EXPECT_EQ(up.lower, 30u);
  EXPECT_LT(*up.superiority, 0.1);
}

TEST(PairedComparison, FalsePositivesAreRareInAFamily) {
  // Five equal methods: ten comparisons, a false positive in at most 5 % of families.
  RandomEngine engine(9);
  int wrong = 0;
  const int families = 200;
  for (int family = 0; family < families; ++family) {
    ResultFixture fixture;
    for (int i = 0; i < 15; ++i) {
      const std::string hash = fixture.add_scenario(Value::of(0.1));
      for (const char* method : {"a", "b", "c", "d", "e"})
        fixture.add_run(hash, method, uniform_real(engine, 0.1, 1));
    }
    for (const auto& c : compare_methods(fixture.table, {"optimality"}, "", {}))
      if (c.verdict == Verdict::Better || c.verdict == Verdict::Worse) {
        ++wrong;
        break;
      }
  }
  EXPECT_LE(wrong, 20);  // 10 expected at most, 3 standard deviations are 9
}

TEST(PairedComparison, RepetitionsOfAScenarioCountOnce) {
  ResultFixture fixture;
  for (int i = 0; i < 12; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    for (int repetition = 0; repetition < 3; ++repetition) {
      fixture.add_run(hash, "a", repetition == 0 ? 0.5 : -1, repetition);
      fixture.add_run(hash, "b", 0.5, repetition);
    }
  }
  const ResultTable table = fixture.table;
  const PairedComparison c = only(table, "success");
  EXPECT_EQ(c.scenarios, 12u);
  EXPECT_EQ(c.pairs, 36u);
  EXPECT_EQ(c.test, PairedComparison::Test::SignedRankExact);
  const PairedComparison values = only(table, "optimality");
  EXPECT_EQ(values.pairs, 12u);
  EXPECT_EQ(values.without_value, 24u);
}

TEST(PairedComparison, EqualDecimalValuesAreEqual) {
  ResultFixture fixture;
  const std::pair<double, double> values[] = {{0.3, 0.1 + 0.2}, {0.5, 0.8}, {0.6, 0.3}};
  for (const auto& [a, b] : values) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    fixture.add_run(hash, "a", a);
    fixture.add_run(hash, "b", b);
  }
  const PairedComparison c = only(fixture.table, "optimality");
  EXPECT_EQ(c.equal, 1u);
  EXPECT_EQ(c.higher, 1u);
  EXPECT_EQ(c.lower, 1u);
  EXPECT_EQ(c.p, 1);                          // one difference of each sign, and of one size
  EXPECT_DOUBLE_EQ(*c.superiority, 4 / 9.0);  // of 9 pairs b is above in 3 and equal in 2
}

TEST(PairedComparison, BaselineIsTheFirstOfEachPair) {
  ResultFixture fixture;
  for (int i = 0; i < 4; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    for (const char* method : {"a", "b", "c"}) fixture.add_run(hash, method, 0.5);
  }
  const ResultTable table = fixture.table;
  EXPECT_EQ(compare_methods(table, {"success"}, "", {}).size(), 3u);
  const auto against_b = compare_methods(table, {"success"}, "b", {});
  ASSERT_EQ(against_b.size(), 2u);
  for (const PairedComparison& c : against_b) EXPECT_EQ(c.a, "b");
  EXPECT_THROW(compare_methods(table, {"success"}, "d", {}), Error);
}

TEST(PairedComparison, PairsTwoResultsByScenarioAndRejectsUnrelatedOnes) {
  ResultTable before = rates(20, 15, 0, 0), after = rates(20, 15, 5, 0);
  before.source = "before";
  after.source = "after";
  const auto family = compare_results(before, after, {"success"}, {});
  ASSERT_EQ(family.size(), 2u);  // methods a and b
  EXPECT_NEAR(*family[0].difference, 0.25, 1e-12);
  EXPECT_NEAR(*family[1].difference, 0, 1e-12);
  for (std::string& hash : after.scenario_hashes) hash[0] = 'f';
  EXPECT_THROW(compare_results(before, after, {"success"}, {}), Error);
  after = rates(20, 15, 5, 0);
  after.methods = {"x", "y"};
  EXPECT_THROW(compare_results(before, after, {"success"}, {}), Error);
}

TEST(Gate, ParsesMetricOperatorAndNumber) {
  const Gate gate = parse_gate("success >= -0.02");
  EXPECT_EQ(gate.metric, "success");
  EXPECT_EQ(gate.comparison, Gate::Comparison::AtLeast);
  EXPECT_EQ(gate.limit, -0.02);
  EXPECT_EQ(parse_gate("time_to_goal<0.5").comparison, Gate::Comparison::Below);
  EXPECT_EQ(parse_gate("a <= 1").comparison, Gate::Comparison::AtMost);
  EXPECT_EQ(parse_gate("a > 1").comparison, Gate::Comparison::Above);
  for (const char* wrong : {"", "success", ">= 1", "success >=", "success = 1", "a >= x"})
    EXPECT_THROW(parse_gate(wrong), Error) << wrong;
}

TEST(Gate, EvaluatesTheDifferenceOrItsInterval) {
  const auto family = compare_methods(rates(50, 40, 1, 0), {"success"}, "", {});  // b: -0.02
  EXPECT_TRUE(evaluate_gate(parse_gate("success >= -0.02"), family, GateOn::Estimate)[0].passed);
  EXPECT_FALSE(evaluate_gate(parse_gate("success > -0.02"), family, GateOn::Estimate)[0].passed);
  EXPECT_FALSE(evaluate_gate(parse_gate("success >= -0.02"), family, GateOn::Interval)[0].passed);
  EXPECT_TRUE(evaluate_gate(parse_gate("success >= -0.5"), family, GateOn::Interval)[0].passed);
  EXPECT_TRUE(evaluate_gate(parse_gate("spl >= 0"), family, GateOn::Estimate).empty());
}

TEST(Gate, FailsWithoutADifference) {
  const auto family = compare_methods(rates(5, 0, 0, 0), {"optimality"}, "", {});
  const GateResult result =
      evaluate_gate(parse_gate("optimality >= -1"), family, GateOn::Estimate).at(0);
  EXPECT_FALSE(result.evaluated);
  EXPECT_FALSE(result.passed);
}

}  // namespace
}  // namespace slalom
