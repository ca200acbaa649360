#include "result_fixture.h"

#include <slalom/analysis/gate.h>
#include <slalom/analysis/paired_comparison.h>
#include <slalom/analysis/power.h>
#include <slalom/analysis/rate_tests.h>
#include <slalom/core/error.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

/// Method a succeeds in the first `both + only_a` of n scenarios, b in `both` and the next
/// `only_b`.
RunColumns rates(int n, int both, int only_a, int only_b) {
  ResultFixture fixture;
  for (int i = 0; i < n; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    const bool a = i < both + only_a;
    const bool b = i < both || (i >= both + only_a && i < both + only_a + only_b);
    fixture.add_run(hash, "a", a ? 0.9 : -1);
    fixture.add_run(hash, "b", b ? 0.9 : -1);
  }
  return to_columns(fixture.table);
}

/// Optimality of b is that of a and `shift` more, with noise of deviation `sigma`.
RunColumns shifted(int n, double shift, double sigma) {
  RandomEngine engine(3);
  ResultFixture fixture;
  for (int i = 0; i < n; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    const double a = uniform_real(engine, 0.4, 0.6);
    fixture.add_run(hash, "a", a);
    fixture.add_run(hash, "b", a + shift + normal(engine, 0, sigma));
  }
  return to_columns(fixture.table);
}

PairedComparison only(const RunColumns& table, const std::string& metric) {
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

TEST(PairedComparison, SaysHowManyScenariosMoreWouldDo) {
  const PairedComparison c = only(rates(10, 6, 1, 2), "success");
  EXPECT_EQ(c.verdict, Verdict::NotEnough);
  // Three of ten differ, and one more for caution: variance 4 / 11; divided by Wilcoxon's 3 / pi.
  const double pairs = static_cast<double>(pairs_needed(0.05, std::sqrt(4.0 / 11), 0.05, 0.8));
  EXPECT_EQ(c.scenarios_needed, static_cast<std::size_t>(std::ceil(pairs * std::acos(-1.0) / 3)));
  const std::string more = std::to_string(c.scenarios_needed - 10) + " scenarios more";
  EXPECT_NE(verdict_sentence(c).find(more), std::string::npos) << verdict_sentence(c);
}

TEST(PairedComparison, SaysThatNothingWasShownOnlyWhereEnoughWasTried) {
  const PairedComparison same = only(shifted(60, 0, 0.01), "optimality");
  EXPECT_EQ(same.verdict, Verdict::NoDifference);
  EXPECT_GE(same.scenarios, same.scenarios_needed);
  EXPECT_EQ(only(shifted(60, 0, 0.1), "optimality").verdict, Verdict::NotEnough);
}

TEST(PairedComparison, FollowsTheDirectionOfTheMetric) {
  const PairedComparison up = only(shifted(30, -0.2, 0.01), "optimality");
  EXPECT_EQ(up.verdict, Verdict::Worse);
  EXPECT_NEAR(up.shift->estimate, -0.2, 0.01);
  EXPECT_EQ(up.lower, 30u);
  EXPECT_LT(*up.superiority, 0.1);
}

TEST(PairedComparison, FalseClaimsAreRareInAFamily) {
  // Five methods that are the same: ten comparisons, some claim in no more than 5 % of families.
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
    for (const auto& c : compare_methods(to_columns(fixture.table), {"optimality"}, "", {}))
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
  const RunColumns table = to_columns(fixture.table);
  const PairedComparison c = only(table, "success");
  EXPECT_EQ(c.scenarios, 12u);
  EXPECT_EQ(c.pairs, 36u);
  EXPECT_EQ(c.test, PairedComparison::Test::SignedRankExact);
  const PairedComparison values = only(table, "optimality");
  EXPECT_EQ(values.pairs, 12u);
  EXPECT_EQ(values.without_value, 24u);
}

TEST(PairedComparison, BaselineIsTheFirstOfEachPair) {
  ResultFixture fixture;
  for (int i = 0; i < 4; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    for (const char* method : {"a", "b", "c"}) fixture.add_run(hash, method, 0.5);
  }
  const RunColumns table = to_columns(fixture.table);
  EXPECT_EQ(compare_methods(table, {"success"}, "", {}).size(), 3u);
  const auto against_b = compare_methods(table, {"success"}, "b", {});
  ASSERT_EQ(against_b.size(), 2u);
  for (const PairedComparison& c : against_b) EXPECT_EQ(c.a, "b");
  EXPECT_THROW(compare_methods(table, {"success"}, "d", {}), Error);
}

TEST(PairedComparison, PairsTwoResultsByScenarioAndRefusesStrangers) {
  RunColumns before = rates(20, 15, 0, 0), after = rates(20, 15, 5, 0);
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

TEST(Gate, ReadsMetricOperatorAndNumber) {
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

TEST(Gate, JudgesTheDifferenceOrItsWholeInterval) {
  const auto family = compare_methods(rates(50, 40, 1, 0), {"success"}, "", {});  // b: -0.02
  EXPECT_TRUE(judge_gate(parse_gate("success >= -0.02"), family, GateOn::Estimate)[0].passed);
  EXPECT_FALSE(judge_gate(parse_gate("success > -0.02"), family, GateOn::Estimate)[0].passed);
  EXPECT_FALSE(judge_gate(parse_gate("success >= -0.02"), family, GateOn::Interval)[0].passed);
  EXPECT_TRUE(judge_gate(parse_gate("success >= -0.5"), family, GateOn::Interval)[0].passed);
  EXPECT_TRUE(judge_gate(parse_gate("spl >= 0"), family, GateOn::Estimate).empty());
}

TEST(Gate, FailsWhereThereIsNothingToJudge) {
  const auto family = compare_methods(rates(5, 0, 0, 0), {"optimality"}, "", {});
  const GateResult result =
      judge_gate(parse_gate("optimality >= -1"), family, GateOn::Estimate).at(0);
  EXPECT_FALSE(result.judged);
  EXPECT_FALSE(result.passed);
}

}  // namespace
}  // namespace slalom
