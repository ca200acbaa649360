#include "io_sample.h"

#include <slalom/core/error.h>
#include <slalom/io/result_columns.h>
#include <slalom/io/result_file.h>

#include <gtest/gtest.h>

#include <fstream>

namespace slalom {
namespace {

/// Runs of two methods in three places, written in no order, every third value missing.
class ResultColumnsTest : public testing::Test {
 protected:
  ResultColumnsTest() : path_(folder_ / "runs.results") {
    ResultFile file = ResultFile::create(
        path_, {{"campaign", "test"}}, {{"density", 1, "Density", "-", Direction::None}},
        {{"success", 1, "Success", "-", Direction::Up}, {"spl", 2, "SPL", "-", Direction::Up}});
    int n = 0;
    for (const std::uint64_t seed : {3, 1, 2}) {
      const Scenario scenario = sample_scenario(seed, "place" + std::to_string(seed));
      ScenarioRecord record{scenario.hash(), scenario.name(), {}};
      record.descriptors["density"] = {
          1, seed == 2 ? Value::na("no free space") : Value::of(0.1 * static_cast<double>(seed))};
      file.add_scenario(record, scenario, {});
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
          RunTiming timing;
          if (n % 2 == 0) timing.values["cycle_time_mean"] = 0.5 * n;
          file.add_run(run, timing, {});
          ++n;
        }
    }
    file.commit();
  }

  TemporaryFolder folder_;
  std::string path_;
};

void expect_same(const ValueColumn& a, const ValueColumn& b) {
  EXPECT_EQ(a.info().id, b.info().id);
  EXPECT_EQ(a.info().version, b.info().version);
  EXPECT_EQ(a.info().direction, b.info().direction);
  EXPECT_EQ(a.rate, b.rate);
  EXPECT_EQ(a.wall_clock, b.wall_clock);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t row = 0; row < a.size(); ++row) {
    ASSERT_EQ(a.is_na(row), b.is_na(row)) << a.info().id << " " << row;
    if (a.is_na(row)) {
      EXPECT_EQ(a.reason(row), b.reason(row));
    } else {
      EXPECT_EQ(a.number(row), b.number(row));
    }
  }
}

TEST_F(ResultColumnsTest, AreWhatTheTableSays) {
  const RunColumns read = read_run_columns(path_);
  const RunColumns expected = to_columns(ResultFile::open(path_).read_table());
  EXPECT_EQ(read.manifest, expected.manifest);
  ASSERT_EQ(read.size(), 12u);
  for (std::size_t run = 0; run < read.size(); ++run)
    EXPECT_EQ(run_id(read, run), run_id(expected, run));
  ASSERT_EQ(read.metrics.size(), expected.metrics.size());
  for (const ValueColumn& column : expected.metrics)
    expect_same(*find_metric(read, column.info().id), column);
  ASSERT_EQ(read.descriptors.size(), 1u);
  expect_same(read.descriptors[0], expected.descriptors[0]);
}

TEST_F(ResultColumnsTest, HoldOnlyWhatWasAskedFor) {
  const RunColumns some = read_run_columns(path_, std::vector<std::string>{"spl"});
  EXPECT_NE(find_metric(some, "spl"), nullptr);
  EXPECT_NE(find_metric(some, "success"), nullptr);  // from the outcomes
  EXPECT_EQ(find_metric(some, "cycle_time_mean"), nullptr);
  EXPECT_TRUE(some.descriptors.empty());
  const RunColumns clocks = read_run_columns(path_, std::vector<std::string>{"cycle_time_mean"});
  EXPECT_NE(find_metric(clocks, "cycle_time_mean"), nullptr);
  EXPECT_EQ(find_metric(clocks, "spl"), nullptr);
  const RunColumns all = read_run_columns(path_, std::vector<std::string>{"slp"});
  EXPECT_NE(find_metric(all, "spl"), nullptr);  // so that a message can name it
}

TEST_F(ResultColumnsTest, RefuseOtherFiles) {
  EXPECT_TRUE(is_database(path_));
  const std::string text = folder_ / "text.csv";
  std::ofstream(text) << "a,b\n1,2\n";
  EXPECT_FALSE(is_database(text));
  EXPECT_THROW(read_run_columns(text), Error);
  EXPECT_THROW(read_run_columns(folder_ / "none"), Error);
}

}  // namespace
}  // namespace slalom
