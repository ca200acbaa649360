// SPDX-License-Identifier: BSD-3-Clause
#include "result_fixture.h"

#include <slalom/analysis/csv_columns.h>
#include <slalom/analysis/method_overview.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// 25 scenarios per bin of density; "a" succeeds in so many of each bin, "b" in all, "c" as a.
ResultTable three_methods(const std::vector<int>& successes) {
  ResultFixture fixture;
  for (int i = 0; i < 25; ++i) {
    for (std::size_t bin = 0; bin < successes.size(); ++bin) {
      const std::string hash =
          fixture.add_scenario(Value::of(0.05 + 0.1 * static_cast<double>(bin)));
      for (const char* method : {"a", "c"})
        fixture.add_run(hash, method, i < successes[bin] ? 0.9 : -1);
      fixture.add_run(hash, "b", 0.9);
    }
  }
  return fixture.table;
}

std::vector<MethodOverview> overview_of(const ResultTable& table) {
  const auto tables =
      build_cross_tables(table, parse_bin_specs("density:0,0.1,0.2"), {"success"}, {});
  const auto family = directed_comparisons(table, tables[0].columns, {});
  return build_overview(table, tables, family, {});
}

TEST(MethodOverview, SaysInASentenceWhatHolds) {
  const auto overview = overview_of(three_methods({25, 15}));
  ASSERT_EQ(overview.size(), 3u);
  // Rate 40 / 50; z = -5 / sqrt(0.16 * 12.5) = -3.536 in two tests; ten scenarios only b solves.
  EXPECT_EQ(overview[1].sentence,
            "a succeeds in 80 % [67, 89] of 50 runs; it falls from 100 % to 60 % with density (in "
            "[0, 0.1) and [0.1, 0.2], p = 0.0008); it collides in 20 %; against b it is 0.20 "
            "worse in success on the same scenarios, p = 0.0039, Holm over 2 pairs; its values "
            "are identical to those of c");
  EXPECT_EQ(overview[0].sentence,
            "b succeeds in 100 % [93, 100] of 50 runs; against a it is 0.20 better in success on "
            "the same scenarios, p = 0.0039, Holm over 2 pairs; against c it is 0.20 better in "
            "success on the same scenarios, p = 0.0039, Holm over 2 pairs");
}

TEST(MethodOverview, HasNoClauseWithoutEvidence) {
  const ResultTable table = three_methods({24, 25});
  EXPECT_EQ(overview_of(table)[1].sentence,
            "a succeeds in 98 % [90, 100] of 50 runs; it collides in 2 %; its values are identical "
            "to those of c");
}

std::string leader_of(const ResultTable& table) {
  return leader_sentence(table, directed_comparisons(table, {}, {}), {});
}

TEST(MethodOverview, NamesTheSecondAndWhetherTheFirstIsBetter) {
  // Newcombe's interval of -0.2: sqrt((0.8 - 0.669625)^2 + ...) by hand is [0.10, 0.33].
  EXPECT_EQ(leader_of(three_methods({25, 15})),
            "b succeeds most often (100 % of 50 runs), a second (80 %): confirmed against a: 0.20 "
            "[0.09, 0.33] better over 50 scenarios, p = 0.0039, Holm over 2 pairs");
  EXPECT_EQ(leader_of(three_methods({24, 25})),
            "b succeeds most often (100 % of 50 runs), a second (98 %): not confirmed against a: "
            "0.02 [-0.05, 0.10] better over 50 scenarios, p = 1.0000, Holm over 2 pairs");
  EXPECT_EQ(leader_of(three_methods({25, 25})),
            "a succeeds most often (100 % of 50 runs), b as often (100 %): identical to b in 50 "
            "pairs of runs");
}

TEST(MethodOverview, ComparesNoFirstWithoutACommonScenario) {
  ResultFixture fixture;
  fixture.add_run(fixture.add_scenario(Value::of(0.1)), "a", 0.5);
  EXPECT_EQ(leader_of(fixture.table), "") << "the only method";
  fixture.add_run(fixture.add_scenario(Value::of(0.1)), "b", -1);
  EXPECT_EQ(leader_of(fixture.table),
            "a succeeds most often (100 % of 1 run), b second (0 %): not compared with b: no "
            "common scenario");
}

TEST(MethodOverview, SortsMethodsBySuccessAndEqualOnesAsInTheResults) {
  std::vector<std::string> methods;
  for (const MethodOverview& entry : overview_of(three_methods({25, 15})))
    methods.push_back(entry.standing.method.method);
  EXPECT_EQ(methods, (std::vector<std::string>{"b", "a", "c"}));
}

TEST(MethodOverview, ShowsFailuresWhereOthersSucceedThoseOfMostFirst) {
  ResultFixture fixture;
  const auto add = [&fixture](double a, double b, double c) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    fixture.add_run(hash, "a", a);
    fixture.add_run(hash, "b", b);
    fixture.add_run(hash, "c", c);
  };
  add(-1, -1, -1);
  add(-1, -1, 0.5);
  add(-1, 0.5, 0.5);
  add(-1, -1, -1);
  add(0.5, 0.5, 0.5);
  const auto overview = overview_of(fixture.table);
  ASSERT_EQ(overview[2].standing.method.method, "a");
  ASSERT_EQ(overview[2].failures.size(), 2u);
  EXPECT_EQ(overview[2].failures[0].run, 6u);
  EXPECT_EQ(overview[2].failures[0].why, "collision; others that succeed here: 2 of 2");
  EXPECT_EQ(overview[2].failures[1].run, 3u);
  ASSERT_EQ(overview[0].standing.method.method, "c");
  EXPECT_TRUE(overview[0].failures.empty()) << "it fails where all do";
}

TEST(MethodOverview, ShowsFailuresInScenariosThatNoOtherMethodHasRun) {
  ResultFixture fixture;
  fixture.add_run(fixture.add_scenario(Value::of(0.1)), "a", -1);
  const auto overview = overview_of(fixture.table);
  ASSERT_EQ(overview[0].failures.size(), 1u);
  EXPECT_EQ(overview[0].failures[0].why, "collision");
}

std::string sentence_of(const std::string& text) {
  const ResultTable table = columns_from_csv(text, "t.csv");
  const auto overview = build_overview(table, {}, {}, {});
  return overview.empty() ? "" : overview[0].sentence;
}

TEST(MethodOverview, SpeaksOfCollisionsOnlyIfTheyAreKnown) {
  // Wilson's interval of 1 in 2 is [0.095, 0.905].
  const std::string half = "all succeeds in 50 % [9, 91] of 2 runs";
  EXPECT_EQ(sentence_of("success\n1\n0\n"), half + "; it fails in 50 %");
  EXPECT_EQ(sentence_of("outcome\nsuccess\ntimeout\n"), half + "; it times out in 50 %");
  EXPECT_EQ(sentence_of("success,collided,timeout\n1,0,0\n0,1,0\n"),
            half + "; it collides in 50 %");
  EXPECT_EQ(sentence_of("success,collided,timeout\n1,0,0\n0,0,1\n"),
            half + "; it times out in 50 %, collides in none (at most 77.7 %)")
      << "1 - sqrt(0.05) = 0.7764";
  EXPECT_EQ(sentence_of("collided,time\n0,5\n1,4\n"), "") << "success is not known";
}

TEST(MethodOverview, DoesNotRoundAFailureAway) {
  std::string runs = "success\n0\n";
  for (int i = 0; i < 599; ++i) runs += "1\n";
  // 1 / 600 is 0.17 %.
  EXPECT_EQ(sentence_of(runs), "all succeeds in 99.8 % [99, 100] of 600 runs; it fails in 0.2 %");
}

TEST(MethodOverview, SpeaksOfMeansWhereSuccessIsNotThatOfRuns) {
  CsvColumnOptions stated;
  stated.ranges = {{"success", {0, 1}}};
  const ResultTable table = columns_from_csv(
      "method,scenario,success\na,1,0.9\na,2,0.8\nb,1,0.5\nb,2,0.4\n", "t.csv", stated);
  const std::string leader = leader_of(table);
  EXPECT_EQ(leader.rfind("a has the largest mean success (85 %), b second (45 %): ", 0), 0u)
      << leader;
  const std::string sentence = build_overview(table, {}, {}, {})[0].sentence;
  EXPECT_EQ(sentence.rfind("a has a mean success of 85 %", 0), 0u) << sentence;
  EXPECT_NE(sentence.find(" over 2 values"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace slalom
