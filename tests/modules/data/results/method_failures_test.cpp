// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/results/method_failures.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

RunRecord run(const std::string& scenario, const std::string& method, const std::string& outcome,
              const std::string& detail = "") {
  RunRecord record;
  record.scenario_name = scenario;
  record.scenario_hash = "hash of " + scenario;
  record.method = method;
  record.outcome = outcome;
  record.outcome_detail = detail;
  return record;
}

TEST(MethodFailures, AreNamedWithTheReasonAndTheFirstRunInWhateverOrderTheyCome) {
  MethodFailures failures;
  failures.add(run("room_2", "mine", "method_error", "ValueError: b"));
  failures.add(run("room_1", "mine", "method_error", "AttributeError: a (mine.py:5)"));
  failures.add(run("room_3", "mine", "success"));
  failures.add(run("room_3", "nd", "collision"));
  const std::vector<std::string> lines = failures.lines();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0],
            "mine: 2 of 3 runs ended with method_error: AttributeError: a (mine.py:5) (first: "
            "room_1/mine/0)");
  EXPECT_TRUE(failures.methods_without_a_sound_run().empty());
  EXPECT_EQ(failures.runs_of("mine"), 3U);
  EXPECT_EQ(failures.runs_of("gap"), 0U);
}

TEST(MethodFailures, OfEveryRunNameTheMethod) {
  MethodFailures failures;
  failures.add(run("room_1", "mine", "method_error", "x"));
  failures.add(run("room_2", "mine", "method_crash", "killed by signal 11"));
  failures.add(run("room_1", "nd", "stuck"));
  EXPECT_EQ(failures.lines().size(), 2U);
  EXPECT_EQ(failures.methods_without_a_sound_run(), std::vector<std::string>{"mine"});
}

TEST(MethodFailures, OfATableAreThoseOfItsRuns) {
  ResultTable table;
  table.scenario_hashes = {"h1", "h2", "h3"};
  table.scenario_names = {"room_2", "room_1", "room_3"};
  table.methods = {"mine", "nd"};
  table.outcomes = {"success", "method_error"};
  table.scenario = {0, 0, 1, 1, 2};
  table.method = {0, 1, 0, 1, 0};
  table.outcome = {1, 0, 1, 0, 0};
  table.repetition = {0, 0, 0, 0, 0};
  MethodFailures failures;
  std::vector<std::string> asked;
  const auto detail_of = [&](const std::string& hash, const std::string& method, int repetition) {
    asked.push_back(hash + "/" + method + "/" + std::to_string(repetition));
    return std::string("ValueError: b");
  };
  failures.add(table, detail_of);
  EXPECT_EQ(asked, std::vector<std::string>{"h2/mine/0"});
  const std::vector<std::string> lines = {
      "mine: 2 of 3 runs ended with method_error: ValueError: b (first: room_1/mine/0)"};
  EXPECT_EQ(failures.lines(), lines);
  EXPECT_EQ(failures.lines_of("mine"), lines);
  EXPECT_TRUE(failures.lines_of("nd").empty());
  failures.add(table, [](const auto&...) { return std::string(); });  // of another shard
  EXPECT_EQ(failures.lines()[0].substr(0, 18), "mine: 4 of 6 runs ");
}

TEST(MethodFailures, AreOneLineEachWhateverTheMethodSays) {
  MethodFailures failures;
  failures.add(run("room_1", "mine", "method_error", "two\nlines \x1b[31m"));
  ASSERT_EQ(failures.lines().size(), 1U);
  EXPECT_EQ(failures.lines()[0].find_first_of("\n\x1b"), std::string::npos);
}

}  // namespace
}  // namespace slalom
