#include <slalom/core/random.h>
#include <slalom/results/run_record.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace slalom {
namespace {

RunRecord run_of(const std::string& scenario, const std::string& hash, const std::string& method,
                 int repetition) {
  RunRecord run;
  run.scenario_name = scenario;
  run.scenario_hash = hash;
  run.method = method;
  run.repetition = repetition;
  return run;
}

std::string label(const RunRecord& run) {
  return run.scenario_name + ' ' + run.scenario_hash + ' ' + run.method + ' ' +
         std::to_string(run.repetition);
}

std::vector<std::string> labels(const ResultTable& table) {
  std::vector<std::string> result;
  for (const RunRecord& run : table.runs) result.push_back(label(run));
  return result;
}

TEST(SortRuns, OrdersByScenarioNameHashMethodAndRepetition) {
  ResultTable table;
  table.runs = {run_of("b", "11", "nd", 0), run_of("a", "22", "nd", 0), run_of("a", "11", "vff", 0),
                run_of("a", "11", "nd", 10), run_of("a", "11", "nd", 9)};
  sort_runs(table);
  EXPECT_EQ(labels(table), (std::vector<std::string>{"a 11 nd 9", "a 11 nd 10", "a 11 vff 0",
                                                     "a 22 nd 0", "b 11 nd 0"}));
}

TEST(SortRuns, GivesOneOrderWhateverTheOrderBeforeAndTakesTheTimingsAlong) {
  ResultTable ordered;
  for (const std::string scenario : {"hall", "office"})
    for (const std::string hash : {"0a", "0b"})
      for (const std::string method : {"nd", "vff"})
        for (int repetition = 0; repetition < 3; ++repetition) {
          ordered.runs.push_back(run_of(scenario, hash, method, repetition));
          ordered.timings.push_back({static_cast<double>(ordered.timings.size()), {}});
        }
  RandomEngine random(3);
  for (int round = 0; round < 20; ++round) {
    ResultTable table = ordered;
    for (std::size_t i = table.runs.size() - 1; i > 0; --i) {
      const auto j = static_cast<std::size_t>(uniform_int(random, 0, static_cast<int>(i)));
      std::swap(table.runs[i], table.runs[j]);
      std::swap(table.timings[i], table.timings[j]);
    }
    sort_runs(table);
    ASSERT_EQ(labels(table), labels(ordered));
    for (std::size_t i = 0; i < table.timings.size(); ++i)
      ASSERT_EQ(table.timings[i].wall_seconds, static_cast<double>(i));
  }
}

TEST(SortRuns, KeepsEverythingThatARunHolds) {
  ResultTable table;
  table.runs = {run_of("b", "2", "nd", 0), run_of("a", "1", "nd", 0)};
  table.runs[1].seed = 77;
  table.runs[1].outcome = "collision";
  table.runs[1].outcome_detail = "at (1, 2)";
  table.runs[1].trajectory_hash = "cafe";
  table.runs[1].metrics["path_length"] = {2, Value::of(4.5)};
  sort_runs(table);
  const RunRecord& run = table.runs[0];
  EXPECT_EQ(run.seed, 77U);
  EXPECT_EQ(run.outcome, "collision");
  EXPECT_EQ(run.outcome_detail, "at (1, 2)");
  EXPECT_EQ(run.trajectory_hash, "cafe");
  EXPECT_EQ(run.metrics.at("path_length").version, 2);
  EXPECT_EQ(run.metrics.at("path_length").value.number(), 4.5);
}

TEST(TimingUnit, OfARatioIsNone) {
  EXPECT_EQ(timing_unit("cycle_time_p95"), "ms");
  EXPECT_EQ(timing_unit("deadline_miss_ratio"), "-");
}

TEST(SortRuns, GivesARunWithoutTimingAnEmptyOne) {
  ResultTable table;
  table.runs = {run_of("b", "2", "nd", 0), run_of("a", "1", "nd", 0)};
  table.timings.push_back({1.5, {{"cycle_time_mean", 0.25}}});
  sort_runs(table);
  ASSERT_EQ(table.timings.size(), 2U);
  EXPECT_EQ(table.timings[0].wall_seconds, 0);
  EXPECT_EQ(table.timings[1].wall_seconds, 1.5);
  EXPECT_EQ(table.timings[1].values.at("cycle_time_mean"), 0.25);
}

TEST(SortRuns, OfAnEmptyTableIsEmpty) {
  ResultTable table;
  sort_runs(table);
  EXPECT_TRUE(table.runs.empty());
  EXPECT_TRUE(table.timings.empty());
}

TEST(RunId, IsEightDigitsOfTheHashMethodAndRepetition) {
  EXPECT_EQ(run_id(run_of("hall", "0123456789abcdef", "nd", 12)), "01234567/nd/12");
  EXPECT_EQ(run_id(run_of("hall", "abc", "nd", 0)), "abc/nd/0");
}

TEST(VersionedValue, IsNotComputedUntilItIs) {
  const VersionedValue value;
  EXPECT_EQ(value.version, 1);
  ASSERT_TRUE(value.value.is_na());
  EXPECT_EQ(value.value.reason(), "not computed");
}

}  // namespace
}  // namespace slalom
