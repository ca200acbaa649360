// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "result_fixture.h"

#include <slalom/analysis/difficulty.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/core/error.h>
#include <slalom/core/random.h>
#include <slalom/results/privileged.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

const Interpreter& difficulty_interpreter() {
  const auto& all = all_interpreters();
  return *std::find_if(all.begin(), all.end(),
                       [](const Interpreter& one) { return one.id == "difficulty"; });
}

Interpretation interpreted(ResultTable table, const std::string& method = "") {
  AnalysisQuery query;
  query.metrics = {"success"};
  query.method = method;
  std::vector<ResultTable> results = {std::move(table)};
  return interpret(difficulty_interpreter(), results, query);
}

bool has_remark(const Interpretation& found, const std::string& part) {
  return std::any_of(found.remarks.begin(), found.remarks.end(), [&](const std::string& remark) {
    return remark.find(part) != std::string::npos;
  });
}

/// A scenario with the outcomes of methods "a", "b", ...: '1' is solved.
void add_outcomes(ResultFixture& fixture, const std::string& outcomes, double density = 0.1) {
  const std::string hash = fixture.add_scenario(Value::of(density));
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    fixture.add_run(hash, std::string(1, static_cast<char>('a' + i)), outcomes[i] == '1' ? 1 : -1);
}

/// a alone solves three scenarios, b alone one, both solve one and none solves one.
ResultFixture two_methods() {
  ResultFixture fixture;
  for (const char* outcomes : {"10", "10", "10", "01", "11", "00"}) add_outcomes(fixture, outcomes);
  return fixture;
}

/// Four methods with abilities of -1.5 to 1.5 in scenarios of 4 families, with a difficulty of -3
/// to 3 that is proportional to the density.
ResultFixture dense(int scenarios) {
  ResultFixture fixture;
  RandomEngine engine(7);
  for (int i = 0; i < scenarios; ++i) {
    const double density = uniform_real(engine, 0, 1);
    std::string outcomes;
    for (int method = 0; method < 4; ++method) {
      const double z = method - 1.5 - 6 * (density - 0.5);
      outcomes += uniform_real(engine, 0, 1) < 1 / (1 + std::exp(-z)) ? '1' : '0';
    }
    add_outcomes(fixture, outcomes, density);
    fixture.table.scenario_names.back() = "f" + std::to_string(i % 4) + "_" + std::to_string(i);
  }
  return fixture;
}

TEST(Difficulty, OfTwoMethodsIsTheLogarithmOfTheRatioOfTheirWins) {
  const DifficultyScale scale = build_difficulty(two_methods().table, "success", {});
  ASSERT_EQ(scale.methods.size(), 2U);
  EXPECT_EQ(scale.methods[0].method, "a");
  EXPECT_NEAR(scale.methods[0].success, 4 / 6.0, 1e-12);
  EXPECT_NEAR(*scale.methods[0].ability, std::log(3.0) / 2, 1e-9);  // 3 to 1, half of it each
  // Half of the standard error sqrt(1/3 + 1) of the difference, times the normal quantile 1.96.
  EXPECT_NEAR(scale.methods[0].interval->high - *scale.methods[0].ability,
              1.959964 * std::sqrt(4 / 3.0) / 2, 1e-6);
  EXPECT_FALSE(scale.methods[0].discrimination) << "two methods";
  EXPECT_EQ(scale.informative, 4U);
  EXPECT_EQ(scale.scenarios[4].solved_by, 2U);
  EXPECT_LT(scale.scenarios[4].difficulty, scale.scenarios[0].difficulty);
  EXPECT_LT(scale.scenarios[0].difficulty, scale.scenarios[5].difficulty);
  // Scenario 3, "01", is solved by the method with fewer successes elsewhere.
  EXPECT_LT(*scale.scenarios[3].discrimination, 0);
  EXPECT_GT(*scale.scenarios[0].discrimination, 0);
  EXPECT_FALSE(scale.scenarios[4].discrimination) << "the same for all methods";
  EXPECT_FALSE(scale.andersen) << "no group in which both win";
  EXPECT_FALSE(scale.geometry) << "six scenarios";
}

TEST(Difficulty, CountsAMethodAsSolvingIfMostOfItsRunsSucceed) {
  ResultFixture fixture = two_methods();
  // Scenario 0, "10": b succeeds in one of two runs, a in two of three.
  const std::string hash = fixture.table.scenario_hashes[0];
  fixture.add_run(hash, "b", 1, 1);
  fixture.add_run(hash, "a", 1, 1);
  fixture.add_run(hash, "a", -1, 2);
  const DifficultyScale scale = build_difficulty(fixture.table, "success", {});
  EXPECT_EQ(scale.scenarios[0].solved_by, 1U);
  EXPECT_NEAR(*scale.methods[0].ability, std::log(3.0) / 2, 1e-9);
}

TEST(Difficulty, LeavesOutScenariosWithoutAValueOfEachMethod) {
  ResultFixture fixture = two_methods();
  fixture.add_run(fixture.add_scenario(Value::of(0.1)), "a", 1);
  const DifficultyScale scale = build_difficulty(fixture.table, "success", {});
  EXPECT_EQ(scale.left_out, 1U);
  EXPECT_EQ(scale.scenarios.size(), 6U);
  EXPECT_TRUE(has_remark(interpreted(fixture.table), "left out: 1 scenario"));
}

TEST(Difficulty, SetsMethodsAsideThatSolveAllOrNone) {
  ResultFixture fixture;
  for (const char* outcomes : {"1010", "1010", "1100", "1110"}) add_outcomes(fixture, outcomes);
  const DifficultyScale scale = build_difficulty(fixture.table, "success", {});
  EXPECT_EQ(scale.methods[0].method, "c");
  EXPECT_NEAR(*scale.methods[0].ability, std::log(2.0) / 2, 1e-9);  // c alone 2, b alone 1
  EXPECT_EQ(scale.methods[2].method, "a");
  EXPECT_FALSE(scale.methods[2].ability);
  EXPECT_EQ(scale.methods[3].method, "d");
  EXPECT_TRUE(has_remark(interpreted(fixture.table), "no finite ability, set aside: a, d"));
}

TEST(Difficulty, ListsMethodsThatAreBetterInHardScenarios) {
  // d alone solves what the others fail, and fails what they agree on.
  ResultFixture fixture;
  for (const char* outcomes : {"1110", "1110", "1110", "1110", "1110", "0001", "0001", "0001",
                               "1100", "1000", "0100", "0010"})
    add_outcomes(fixture, outcomes);
  const Interpretation found = interpreted(fixture.table);
  EXPECT_TRUE(
      has_remark(found, "negative discrimination, better in hard scenarios than in easy ones: d"))
      << render_text(found);
}

TEST(Difficulty, IsPredictedFromTheDescriptorThatMakesIt) {
  ResultFixture fixture = dense(400);
  const DifficultyScale scale = build_difficulty(fixture.table, "success", {});
  ASSERT_TRUE(scale.geometry);
  const GeometryFit& fit = *scale.geometry;
  EXPECT_EQ(fit.descriptors, (std::vector<std::string>{"density"})) << "clearness is constant";
  EXPECT_EQ(fit.families, 4U);
  // The difficulty has the variance 3, of a uniform one of width 6. Four outcomes measure it with
  // an error of a variance near 1 / information = 1 / (4 x 0.25) at best: R^2 is below 0.75.
  EXPECT_GT(*fit.descriptors_r2, 0.5);
  EXPECT_LT(*fit.descriptors_r2, 0.75);
  EXPECT_NEAR(*fit.held_out_r2, *fit.descriptors_r2, 0.05) << "families are alike";
  EXPECT_LT(*fit.family_r2, 0.05);
  ASSERT_EQ(fit.leading.size(), 1U);
  EXPECT_NEAR(fit.leading[0].second, *fit.descriptors_r2, 1e-12);
  double low = 0, high = 0;
  for (std::size_t i = 0; i < 400; ++i)
    (fixture.table.descriptors[1].number(i) < 0.5 ? low : high) += *scale.scenarios[i].predicted;
  EXPECT_LT(low, high);
  ASSERT_TRUE(scale.andersen);
  EXPECT_GT(scale.andersen->p, 0.01) << "made by the model";
}

TEST(Difficulty, UsesDescriptorsWithAllValuesAndNamesTheOthers) {
  ResultFixture fixture = dense(60);
  ValueColumn partial(QuantityInfo{"partial", 1, "Partial", "-"});
  for (int i = 0; i < 60; ++i) partial.add(i == 30 ? Value::na("no path") : Value::of(i));
  fixture.table.descriptors.push_back(partial);
  const Interpretation found = interpreted(fixture.table);
  EXPECT_TRUE(has_remark(found, "not used, without a value in some scenario: partial"));
  EXPECT_EQ(build_difficulty(fixture.table, "success", {}).geometry->descriptors.size(), 1U);
}

TEST(Difficulty, SaysInWordsWhatTheTestsOfOneScaleFind) {
  // Half of the scenarios are hard for a and c only, the others for b and d only.
  ResultFixture groups;
  for (int i = 0; i < 30; ++i)
    for (const char* outcomes : {"1010", "0101", "1011", "0111", "0010", "0100"})
      add_outcomes(groups, outcomes);
  const Interpretation found = interpreted(groups.table);
  EXPECT_TRUE(has_remark(found,
                         "two groups of methods find different scenarios hard (p = 0.0020): a, c "
                         "against b, d"));
  EXPECT_TRUE(has_remark(found, "one scale does not fit"));
  const Interpretation one = interpreted(dense(400).table);
  EXPECT_TRUE(has_remark(one, "one scale is not refuted by a test that compares"));
  EXPECT_TRUE(has_remark(one, "one dimension of difficulty is not refuted by a test that looks"));
  EXPECT_TRUE(has_remark(one,
                         "abilities are not shown to differ between easy and hard scenarios "
                         "(Andersen, 4 methods, p = "));
}

TEST(Difficulty, SaysInWordsWhatCannotBeTested) {
  const Interpretation found = interpreted(two_methods().table);
  EXPECT_TRUE(has_remark(found,
                         "one dimension of difficulty is not tested: NA, that takes at least "
                         "4 methods with an ability"));
  EXPECT_TRUE(has_remark(found,
                         "whether abilities differ between easy and hard scenarios cannot be "
                         "tested with these runs"));
}

TEST(Difficulty, SaysInWordsWhetherAbilitiesDifferBetweenEasyAndHardScenarios) {
  // In easy scenarios, solved by three of four, a fails least; in hard ones, solved by one, it wins
  // least: no common order.
  ResultFixture fixture;
  for (int i = 0; i < 30; ++i) {
    for (const char* outcomes : {"1110", "1101", "1011", "0001", "0010", "0100"})
      add_outcomes(fixture, outcomes);
    if (i % 10 == 0)
      for (const char* outcomes : {"0111", "1000"}) add_outcomes(fixture, outcomes);
  }
  EXPECT_TRUE(has_remark(
      interpreted(fixture.table),
      "abilities differ between easy and hard scenarios (Andersen, 4 methods, p < 0.0001)"));
}

TEST(Difficulty, ShowsTheExpectationsOfTheResiduals) {
  const DataTable abilities = interpreted(dense(400).table).tables[0];
  EXPECT_EQ(abilities.columns,
            (std::vector<std::string>{"method", "success", "ability", "ability.low", "ability.high",
                                      "infit", "infit_expected", "outfit", "outfit_expected",
                                      "discrimination"}));
  double infit = 0, expected = 0;
  for (std::size_t row = 0; row < 4; ++row) {
    infit += std::get<double>(abilities.at(row, 5)) / 4;
    expected += std::get<double>(abilities.at(row, 6)) / 4;
  }
  EXPECT_LT(expected, 0.95) << "not 1";
  EXPECT_NEAR(infit, expected, 0.05) << "made by the model";
}

TEST(Difficulty, HasTheSameTablesInAllFormats) {
  const Interpretation found = interpreted(dense(60).table);
  const auto json = nlohmann::json::parse(render_json(found));
  std::vector<std::string> names;
  for (const auto& table : json["tables"]) names.push_back(table["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"abilities", "fit", "difficulty_by_solvers",
                                             "geometry", "leading", "scenarios"}));
  EXPECT_EQ(json["tables"][5]["rows"].size(), 60U);
  EXPECT_NE(render_csv(found).find("\nscenario,scenario_hash,solved_by,difficulty,predicted"),
            std::string::npos);
  EXPECT_EQ(render_text(found).find("predicted_difficulty"), std::string::npos) << "60 rows";
}

TEST(Difficulty, ShowsOneMethodAndTheMarksOfPrivilegedOnes) {
  ResultTable table = two_methods().table;
  table.manifest[kPrivilegedKey] = "b";
  EXPECT_EQ(interpreted(table, "a").tables[0].rows, 1U);
  const std::string text = render_text(interpreted(table));
  EXPECT_NE(text.find("\nb*"), std::string::npos) << text;
  EXPECT_NE(text.find("* privileged: b"), std::string::npos) << text;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "", {"'c'"}, [&] { interpreted(table, "c"); }));
}

TEST(Difficulty, RejectsWhatHasNoScale) {
  const auto rejects = [](const ResultTable& table, const std::vector<std::string>& metrics,
                          const std::string& what) {
    AnalysisQuery query;
    query.metrics = metrics;
    return throws_error(ErrorKind::Usage, "difficulty: ", {what},
                        [&] { difficulty_interpreter().interpret({table}, query); });
  };
  const ResultTable table = two_methods().table;
  EXPECT_TRUE(rejects(table, {"path_length"},
                      "'path_length' is not a rate; expected a metric of 0 or 1, such as success"));
  EXPECT_TRUE(rejects(table, {"success", "spl"}, "2 metrics; expected one, such as success"));
  ResultFixture ordered;
  add_outcomes(ordered, "10");
  EXPECT_TRUE(rejects(ordered.table, {"success"},
                      "no two methods each solve a scenario that the other one fails"));
  ResultFixture many;
  const std::string hash = many.add_scenario(Value::of(0.1));
  for (int i = 0; i < 65; ++i) many.add_run(hash, "m" + std::to_string(i), 1);
  EXPECT_TRUE(rejects(many.table, {"success"}, "65 methods; expected at most 64"));
}

TEST(Difficulty, FamiliesAreTheNamesWithoutTheirNumbers) {
  EXPECT_EQ(family_in_name("random_0012"), "random");
  EXPECT_EQ(family_in_name("hall_2_0012"), "hall_2");
  EXPECT_EQ(family_in_name("world12"), "world12");
  EXPECT_EQ(family_in_name("office"), "office");
  EXPECT_EQ(family_in_name("_1"), "_1");
  EXPECT_EQ(family_in_name(""), "");
}

}  // namespace
}  // namespace slalom
