// SPDX-License-Identifier: BSD-3-Clause
#include "rank_stability.h"
#include "result_fixture.h"

#include <slalom/analysis/csv_columns.h>
#include <slalom/analysis/history.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/core/error.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// Twelve scenarios; method "a" has these values, "b" 0.5.
ResultTable version(const std::string& source, const std::vector<double>& values) {
  ResultFixture fixture;
  for (const double value : values) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    fixture.add_run(hash, "a", value);
    fixture.add_run(hash, "b", 0.5);
  }
  fixture.table.source = source;
  return fixture.table;
}

std::vector<ResultTable> versions() {
  std::vector<double> first(12, 0.3), second(12, 0.4), third(12, 0.4);
  for (std::size_t i = 0; i < 12; ++i) second[i] += 0.001 * static_cast<double>(i);
  second[11] = -1;  // mended in the third version
  third[0] = -1;
  return {version("v1", first), version("v2", second), version("v3", third)};
}

TEST(History, ComparesEachResultWithTheOneBefore) {
  const History history = build_history(versions(), {"optimality"}, {});
  ASSERT_EQ(history.curves.size(), 2u);
  const auto& points = history.curves[0].points;
  ASSERT_EQ(points.size(), 3u);
  EXPECT_FALSE(points[0].change);
  EXPECT_EQ(points[1].change->verdict, Verdict::Better);
  EXPECT_EQ(points[1].change->scenarios, 11u);
  // Eleven differences of one sign; b is identical and not in the family, the other change is.
  EXPECT_DOUBLE_EQ(points[1].change->adjusted_p, 2 * 2.0 / 2048);
  EXPECT_EQ(history.curves[1].points[1].change->verdict, Verdict::Identical);
}

TEST(History, ListsTheRunsOfTheLastResultThatChanged) {
  const auto results = versions();
  const History history = build_history(results, {"success"}, {});
  ASSERT_EQ(history.new_failures.size(), 1u);
  EXPECT_EQ(history.new_failures[0].now, "collision");
  EXPECT_EQ(results[2].scenario[history.new_failures[0].run], 0u);
  ASSERT_EQ(history.new_successes.size(), 1u);
  EXPECT_EQ(results[2].scenario[history.new_successes[0].run], 11u);
  EXPECT_EQ(history.compared_runs, 24u);
  EXPECT_TRUE(build_history(results, {"success"}, {}, "b").new_failures.empty());
}

TEST(History, PairsByTheHashesOfScenariosAndSkipsResultsWithoutAMethod) {
  auto results = versions();
  results[1].scenario_hashes[0] = std::string(32, 'f');
  results[1].methods = {"x", "b"};
  const History history = build_history(results, {"success"}, {});
  EXPECT_EQ(history.curves[0].method, "a");
  ASSERT_EQ(history.curves[0].points.size(), 2u);
  EXPECT_EQ(history.curves[0].points[1].result, 2u);
  EXPECT_EQ(history.compared_runs, 11u) << "of b, without the scenario that differs";
  EXPECT_THROW(build_history(results, {"success"}, {}, "none"), Error);
  EXPECT_THROW(build_history({results[0]}, {"success"}, {}), Error);
}

ResultTable table_of(const std::string& text, const std::string& name) {
  return columns_from_csv("scenario,method,repetition," + text, name);
}

TEST(History, TablesWithoutOutcomesAreComparedBySuccess) {
  const History history = build_history({table_of("success\ns1,a,0,1\ns2,a,0,0\n", "1.csv"),
                                         table_of("success\ns1,a,0,0\ns2,a,0,1\n", "2.csv")},
                                        {"success"}, {});
  ASSERT_EQ(history.new_failures.size(), 1u);
  EXPECT_EQ(history.new_failures[0].now, "failure");
  EXPECT_EQ(history.new_successes.size(), 1u);
  EXPECT_EQ(history.compared_runs, 2u);
}

TEST(History, SaysWhenNewFailuresCannotBeTold) {
  AnalysisQuery query;
  query.metrics = {"time"};
  for (const Interpreter& interpreter : all_interpreters()) {
    if (interpreter.id != "history") continue;
    const std::string json = render_json(interpreter.interpret(
        {table_of("time\ns1,a,0,1\n", "1.csv"), table_of("time\ns1,a,0,2\n", "2.csv")}, query));
    EXPECT_NE(json.find("new failures cannot be told in 1 run"), std::string::npos) << json;
    EXPECT_EQ(json.find("new_failures"), std::string::npos) << json;
    EXPECT_EQ(json.find("0 new failures"), std::string::npos) << json;
  }
}

TEST(History, ShowsNewFailuresFirst) {
  AnalysisQuery query;
  query.metrics = {"success"};
  for (const Interpreter& interpreter : all_interpreters()) {
    if (interpreter.id != "history") continue;
    const Interpretation found = interpreter.interpret(versions(), query);
    const std::string text = render_text(found);
    EXPECT_EQ(text.rfind("New failures: v3 against v2\n\nscenario  run", 0), 0u) << text;
    EXPECT_NE(text.find("→ v3 against v2: 1 new failure and 1 new success in 24 runs of the same "
                        "scenarios\n"),
              std::string::npos)
        << text;
    const std::string page = render_html(found, "history: <v>");
    EXPECT_NE(page.find("<title>history: &lt;v&gt;</title>"), std::string::npos);
    EXPECT_NE(page.find("<h2>a: success by result file</h2>\n<table>\n<thead><tr><th>results</th>"),
              std::string::npos)
        << page;
    EXPECT_NE(page.find("<li>v3 against v2: 1 new failure"), std::string::npos);
    const std::string latex = render_latex(found);
    EXPECT_NE(latex.find("a: success by result file."), std::string::npos) << latex;
    EXPECT_NE(latex.find("v2 & 12 & 0.917 {[}"), std::string::npos) << latex;
    return;
  }
  FAIL() << "no verb history";
}

/// Each method has one of these values in all of ten scenarios, in turn.
ResultTable methods_with(const std::vector<std::vector<double>>& values) {
  ResultFixture fixture;
  for (std::size_t i = 0; i < 10; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    for (std::size_t method = 0; method < values.size(); ++method)
      fixture.add_run(hash, std::string(1, static_cast<char>('a' + method)),
                      values[method][i % values[method].size()]);
  }
  return fixture.table;
}

TEST(RankStability, IsKendallsTauOfTheMethodsMeans) {
  const ResultTable first = methods_with({{0.1}, {0.2}, {0.3}, {0.4}}),
                    swapped = methods_with({{0.1}, {0.2}, {0.4}, {0.3}}),
                    opposite = methods_with({{0.4}, {0.3}, {0.2}, {0.1}});
  const RankStability same = rank_stability(first, first, "optimality", {}, "x");
  EXPECT_EQ(*same.tau, 1);
  EXPECT_EQ(same.interval->low, 1);
  EXPECT_EQ(same.scenarios, 10u);
  EXPECT_DOUBLE_EQ(*rank_stability(first, swapped, "optimality", {}, "x").tau, 4.0 / 6);
  EXPECT_EQ(*rank_stability(first, opposite, "optimality", {}, "x").tau, -1);
}

TEST(RankStability, HasAnIntervalOverScenarios) {
  const ResultTable first = methods_with({{0.1}, {0.5}});
  // b is above a in three of five scenarios, by the same difference.
  const ResultTable other = methods_with({{0.3}, {0.5, 0.1, 0.5, 0.1, 0.5}});
  const RankStability found = rank_stability(first, other, "optimality", {}, "x");
  EXPECT_EQ(*found.tau, 1);
  EXPECT_EQ(found.interval->low, -1);
  EXPECT_EQ(found.interval->high, 1);
}

/// Optimalities around 0.3, 0.35, ... of eight methods, in this order or in that of `order`.
ResultTable noisy_methods(const std::vector<int>& order, RandomEngine& engine) {
  std::vector<std::vector<double>> values;
  for (const int rank : order) {
    values.emplace_back();
    for (int i = 0; i < 10; ++i)
      values.back().push_back(0.3 + 0.05 * rank + uniform_real(engine, -0.2, 0.2));
  }
  return methods_with(values);
}

TEST(RankStability, TellsNoiseFromOrdersThatDiffer) {
  RandomEngine engine(5);
  const std::vector<int> order = {0, 1, 2, 3, 4, 5, 6, 7}, turned = {4, 5, 6, 7, 0, 1, 2, 3};
  int below_one = 0, false_alarms = 0, found = 0;
  const int pairs = 100;
  for (int i = 0; i < pairs; ++i) {
    const ResultTable first = noisy_methods(order, engine);
    const RankStability same =
        rank_stability(first, noisy_methods(order, engine), "optimality", {}, "x");
    ASSERT_TRUE(same.ceiling);
    below_one += *same.tau < 1 ? 1 : 0;
    false_alarms += *same.tau < same.ceiling->interval.low ? 1 : 0;
    const RankStability other =
        rank_stability(first, noisy_methods(turned, engine), "optimality", {}, "x");
    found += *other.tau < other.ceiling->interval.low ? 1 : 0;
  }
  EXPECT_GT(below_one, pairs / 2) << "one true order seldom gives the same measured one";
  EXPECT_LT(false_alarms, pairs / 10);
  EXPECT_EQ(found, pairs);
}

TEST(RankStability, OfTheSameRunsHasACeilingOfOne) {
  const ResultTable first = methods_with({{0.1, 0.3}, {0.3, 0.25}, {0.3, 0.35}});
  const auto ceiling = rank_stability(first, first, "optimality", {}, "x").ceiling;
  EXPECT_EQ(ceiling->mean, 1);
  EXPECT_EQ(ceiling->interval.low, 1);
}

TEST(RankStability, NeedsScenariosInWhichAllHaveValues) {
  const ResultTable first = methods_with({{0.1}, {0.5}});
  const RankStability none =
      rank_stability(first, methods_with({{-1}, {0.5}}), "optimality", {}, "");
  EXPECT_EQ(none.scenarios, 0u);
  EXPECT_FALSE(none.tau);
  EXPECT_EQ(rank_stability(first, methods_with({{-1, 0.5}, {0.6}}), "optimality", {}, "").scenarios,
            5u);
  EXPECT_FALSE(rank_stability(first, methods_with({{0.1}}), "optimality", {}, "").tau);
}

}  // namespace
}  // namespace slalom
