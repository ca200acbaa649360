// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "io_sample.h"

#include <slalom/io/result_fields.h>
#include <slalom/io/result_file.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// Runs of the methods nd (three in the first scenario) and mine (one in the second).
class ResultFieldsTest : public testing::Test {
 protected:
  ResultFieldsTest() {
    ResultFile file = ResultFile::create(path_, {}, {},
                                         {{"path_length", 2, "Path length", "m", Direction::Down}});
    for (const Scenario& scenario : {first_, second_})
      file.add_scenario({scenario.hash(), scenario.name(), {}}, scenario, {});
    add(file, first_, "nd", 0, "success", Value::of(8));
    add(file, first_, "nd", 1, "collision", Value::na("outcome: collision"));
    add(file, first_, "nd", 2, "success", Value::of(9));
    add(file, second_, "mine", 0, "stuck", Value::na("outcome: stuck"));
    file.commit();
  }
  static void add(ResultFile& file, const Scenario& scenario, const std::string& method,
                  int repetition, const std::string& outcome, const Value& length) {
    RunRecord run;
    run.scenario_hash = scenario.hash();
    run.scenario_name = scenario.name();
    run.method = method;
    run.repetition = repetition;
    run.outcome = outcome;
    run.metrics["path_length"] = {2, length};
    file.add_run(run, {}, {});
  }

  TemporaryFolder folder_;
  std::string path_ = folder_ / "a.results";
  Scenario first_ = sample_scenario(1, "first"), second_ = sample_scenario(2, "second");
};

TEST_F(ResultFieldsTest, AreTheOutcomeAndTheMetricsOfEachMethod) {
  const ResultFields fields(path_);
  EXPECT_EQ(fields.methods(), (std::vector<std::string>{"mine", "nd"}));
  EXPECT_EQ(fields.of_method("nd"),
            (std::vector<std::string>{"outcome.nd", "success.nd", "path_length.nd"}));
  EXPECT_TRUE(fields.contains("success.mine"));
  EXPECT_FALSE(fields.contains("success"));
  EXPECT_FALSE(fields.contains("safety.mine"));
}

TEST_F(ResultFieldsTest, AreMeansOverTheRunsInWhichTheValueIsKnown) {
  const ResultFields fields(path_);
  const auto success = fields.read("success.nd");
  ASSERT_EQ(success->numbers.size(), 1U) << "the second scenario has no run of nd";
  EXPECT_DOUBLE_EQ(success->numbers.at(first_.hash()).number(), 2.0 / 3);
  const auto length = fields.read("path_length.nd");
  EXPECT_EQ(length->unit, "m");
  EXPECT_EQ(length->numbers.at(first_.hash()), Value::of(8.5));
  EXPECT_EQ(fields.read("path_length.mine")->numbers.at(second_.hash()),
            Value::na("outcome: stuck"));
  EXPECT_EQ(fields.read("success.nd"), success) << "read once";
}

TEST_F(ResultFieldsTest, HaveAllOutcomesOfAScenario) {
  const auto outcomes = ResultFields(path_).read("outcome.nd");
  ASSERT_TRUE(outcomes->is_text);
  EXPECT_EQ(outcomes->texts.at(first_.hash()), (std::set<std::string>{"collision", "success"}));
  EXPECT_EQ(outcomes->texts.count(second_.hash()), 0U);
}

TEST_F(ResultFieldsTest, AreProvidedAsFarAsASelectionUsesThem) {
  const ResultFields fields(path_);
  SelectionVocabulary vocabulary{{"density"}, {"name"}, {}};
  fields.add_to(vocabulary);
  ListSelection selection;
  selection.where = parse_selection("path length.nd > 1 and outcome.mine = stuck", vocabulary);
  selection.order = parse_selection_order("success.nd, name", vocabulary);
  fields.provide(selection);
  std::vector<std::string> provided;
  for (const auto& [name, field] : selection.fields) provided.push_back(name);
  EXPECT_EQ(provided, (std::vector<std::string>{"outcome.mine", "path_length.nd", "success.nd"}));
}

TEST_F(ResultFieldsTest, OfAMissingFileAreRefused) {
  EXPECT_TRUE(throws_error(ErrorKind::File, folder_ / "none.results", {},
                           [&] { ResultFields(folder_ / "none.results"); }));
}

}  // namespace
}  // namespace slalom
