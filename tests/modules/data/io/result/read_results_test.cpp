// SPDX-License-Identifier: BSD-3-Clause
#include "io_sample.h"

#include <slalom/analysis/data_table.h>
#include <slalom/core/error.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/results/table_builder.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <fstream>

namespace slalom {
namespace {

/// Runs of two methods in three scenarios in arbitrary order, every third value missing.
class ResultColumnsTest : public testing::Test {
 protected:
  ResultColumnsTest() : path_(folder_ / "runs.results") {
    ResultFile file =
        ResultFile::create(path_, {{"campaign", "test"}}, kReadDescriptors, kReadMetrics);
    int n = 0;
    for (const std::uint64_t seed : {3, 1, 2}) {
      const Scenario scenario = sample_scenario(seed, "scenario" + std::to_string(seed));
      ScenarioRecord record{scenario.hash(), scenario.name(), {}};
      record.descriptors["density"] = {
          1, seed == 2 ? Value::na("no free space") : Value::of(0.1 * static_cast<double>(seed))};
      file.add_scenario(record, scenario, {});
      builder_.add_scenario(record);
      for (const char* method : {"nd", "gap"})
        for (int repetition = 1; repetition >= 0; --repetition) {
          RunRecord run;
          run.scenario_hash = scenario.hash();
          run.scenario_name = scenario.name();
          run.method = method;
          run.repetition = repetition;
          run.outcome = n % 3 == 0 ? "stuck" : "success";
          run.metrics["success"] = {1, Value::of(n % 3 == 0 ? 0 : 1)};
          run.metrics["spl"] = {2, n % 3 == 0 ? Value::na("outcome: stuck") : Value::of(0.1 * n)};
          run.seed = 18446744073709551600U + static_cast<std::uint64_t>(n);
          run.outcome_detail = "detail " + std::to_string(n);
          run.trajectory_hash = std::to_string(n);
          RunTiming timing;
          timing.wall_seconds = n;
          if (n % 2 == 0) timing.values["cycle_time_mean"] = 0.5 * n;
          file.add_run(run, timing, {});
          builder_.add_run(run, timing);
          ++n;
        }
    }
    file.commit();
  }

  const std::vector<QuantityInfo> kReadDescriptors = {
      {"density", 1, "Density", "-", Direction::None}};
  const std::vector<QuantityInfo> kReadMetrics = {success_info(),
                                                  {"spl", 2, "SPL", "-", Direction::Up}};
  TableBuilder builder_{kReadDescriptors, kReadMetrics};  ///< with the records of the file
  TemporaryFolder folder_;
  std::string path_;
};

TEST_F(ResultColumnsTest, HaveTheRunsInOrder) {
  const ResultTable table = read_results(path_);
  EXPECT_EQ(table.source, path_);
  EXPECT_EQ(table.manifest.at("campaign"), "test");
  EXPECT_EQ(table.scenario_names,
            (std::vector<std::string>{"scenario1", "scenario2", "scenario3"}));
  EXPECT_EQ(table.methods, (std::vector<std::string>{"gap", "nd"}));
  EXPECT_EQ(table.outcomes, (std::vector<std::string>{"success", "stuck"}));
  ASSERT_EQ(table.size(), 12u);
  for (std::uint32_t run = 0; run < table.size(); ++run) {
    EXPECT_EQ(table.scenario[run], run / 4);
    EXPECT_EQ(table.method[run], run / 2 % 2);
    EXPECT_EQ(table.repetition[run], run % 2);
  }
  EXPECT_TRUE(table.details.empty());
}

/// Each run was written with a number `n`, from which all its values follow.
TEST_F(ResultColumnsTest, HaveTheValuesOfEachRun) {
  const ResultTable table = read_detailed_results(path_);
  const ValueColumn &success = *find_metric(table, "success"), &spl = *find_metric(table, "spl"),
                    &cycle_time = *find_metric(table, "cycle_time_mean");
  EXPECT_TRUE(success.info().is_rate());
  EXPECT_EQ(spl.info().version, 2);
  EXPECT_EQ(spl.info().direction, Direction::Up);
  EXPECT_TRUE(cycle_time.wall_clock);
  EXPECT_EQ(cycle_time.info().unit, "ms");
  ASSERT_EQ(table.details.size(), table.size());
  const std::vector<int> number = {7, 6, 5, 4, 11, 10, 9, 8, 3, 2, 1, 0};
  for (std::size_t run = 0; run < table.size(); ++run) {
    const int n = number[run];
    const bool stuck = n % 3 == 0;
    EXPECT_EQ(table.outcomes[table.outcome[run]], stuck ? "stuck" : "success") << n;
    EXPECT_EQ(success.number(run), stuck ? 0 : 1);
    ASSERT_EQ(spl.is_na(run), stuck);
    if (stuck) {
      EXPECT_EQ(spl.reason(run), "outcome: stuck");
    } else {
      EXPECT_EQ(spl.number(run), 0.1 * n);
    }
    ASSERT_EQ(cycle_time.is_na(run), n % 2 != 0);
    if (n % 2 == 0) {
      EXPECT_EQ(cycle_time.number(run), 0.5 * n);
    } else {
      EXPECT_EQ(cycle_time.reason(run), "not recorded");
    }
    const RunDetails& details = table.details[run];
    EXPECT_EQ(details.seed, 18446744073709551600U + static_cast<std::uint64_t>(n));
    EXPECT_EQ(details.outcome_detail, "detail " + std::to_string(n));
    EXPECT_EQ(details.trajectory_hash, std::to_string(n));
    EXPECT_EQ(details.wall_seconds, n);
  }
}

TEST_F(ResultColumnsTest, EqualTheTableBuiltFromTheSameRecords) {
  const ResultTable read = read_detailed_results(path_), built = builder_.finish();
  for (const auto& table : {runs_table, scenarios_table, timings_table})
    EXPECT_EQ(render_csv(table(read)), render_csv(table(built)));
}

TEST_F(ResultColumnsTest, HaveAReasonForEachMissingDescriptor) {
  const std::string path = folder_ / "reasons.results";
  const std::vector<std::map<std::string, VersionedValue>> descriptors = {
      {{"density", {0, Value::of(0.1)}}}, {{"density", {1, Value::na("no free space")}}}, {}};
  {
    ResultFile file = ResultFile::create(path, {}, kReadDescriptors, kReadMetrics);
    for (std::size_t i = 0; i < descriptors.size(); ++i) {
      const Scenario scenario = sample_scenario(i, "scenario" + std::to_string(i));
      file.add_scenario({scenario.hash(), scenario.name(), descriptors[i]}, scenario, {});
    }
    file.commit();
  }
  const ValueColumn density = read_results(path).descriptors.at(0);
  EXPECT_EQ(density.reason(0), "other version 0");
  EXPECT_EQ(density.reason(1), "no free space");
  EXPECT_EQ(density.reason(2), "not recorded");
}

TEST_F(ResultColumnsTest, IncludeScenariosWithoutRuns) {
  {
    SQLite::Database database(path_, SQLite::OPEN_READWRITE);
    database.exec("DELETE FROM runs WHERE scenario_name = 'scenario1'");
  }
  const ResultTable table = read_results(path_);
  EXPECT_EQ(table.scenario_names.size(), 3u);
  EXPECT_EQ(table.descriptors.at(0).number(0), 0.1);
  EXPECT_EQ(table.size(), 8u);
}

TEST_F(ResultColumnsTest, ContainOnlyTheRequestedQuantities) {
  const ResultTable some = read_results(path_, std::vector<std::string>{"spl"});
  EXPECT_NE(find_metric(some, "spl"), nullptr);
  EXPECT_NE(find_metric(some, "success"), nullptr);  // from the outcomes
  EXPECT_EQ(find_metric(some, "cycle_time_mean"), nullptr);
  EXPECT_TRUE(some.descriptors.empty());
  const ResultTable timings = read_results(path_, std::vector<std::string>{"cycle_time_mean"});
  EXPECT_NE(find_metric(timings, "cycle_time_mean"), nullptr);
  EXPECT_EQ(find_metric(timings, "spl"), nullptr);
  const ResultTable all = read_results(path_, std::vector<std::string>{"slp"});
  EXPECT_NE(find_metric(all, "spl"), nullptr);  // so that a message can suggest it
}

TEST_F(ResultColumnsTest, RejectOtherFiles) {
  EXPECT_TRUE(is_database(path_));
  const std::string text = folder_ / "text.csv";
  std::ofstream(text) << "a,b\n1,2\n";
  EXPECT_FALSE(is_database(text));
  EXPECT_THROW(read_results(text), Error);
  EXPECT_THROW(read_results(folder_ / "none"), Error);
}

}  // namespace
}  // namespace slalom
