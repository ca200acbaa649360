// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "io_sample.h"

#include <slalom/io/own_columns.h>
#include <slalom/io/read_results.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

class OwnColumns : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "x.results", own_ = folder_ / "own.results";

  /// Runs of two methods in two scenarios, the first of them without samples.
  OwnColumns() {
    QuantityInfo density, time;
    density.id = "density";
    time.id = "time";
    ResultFile file = ResultFile::create(path_, {{"campaign", "mine"}}, {density}, {time});
    int run = 0;
    for (const std::uint64_t seed : {1, 2}) {
      const Scenario scenario = sample_scenario(seed, "s" + std::to_string(seed));
      file.add_scenario({scenario.hash(), scenario.name(), {{"density", {1, Value::of(0.25)}}}},
                        scenario, {});
      for (const char* method : {"a", "b"}) {
        Trajectory trajectory;
        trajectory.samples.resize(static_cast<std::size_t>(run));
        RunRecord record;
        record.scenario_hash = scenario.hash();
        record.scenario_name = scenario.name();
        record.method = method;
        record.outcome = "success";
        record.metrics = {{"time", {1, Value::of(++run)}}};
        file.add_run(record, {run * 1.0, {{"cycle_time_mean", 2.0}}, "printed"}, trajectory);
      }
    }
    file.commit();
  }

  static OwnColumn column_of(const std::string& id, const std::vector<double>& values) {
    QuantityInfo info{id, 3, id, "m", Direction::Down, QuantityKind::Count, Range::at_least(0)};
    OwnColumn column{ValueColumn(info), false, "f(x)"};
    for (const double value : values) column.values.add_number(value);
    return column;
  }

  void write(const OwnColumn& column, const std::string& path) const {
    write_with_column(ResultFile::open(path_), read_results(path_), column, path);
  }
};

TEST_F(OwnColumns, AreAddedToAllThatTheFileHas) {
  OwnColumn metric = column_of("comfort", {7, 8, 9});
  metric.values.add_na("asleep");
  write(metric, own_);
  OwnColumn descriptor = column_of("trees", {11, 12});
  descriptor.is_descriptor = true;
  write_with_column(ResultFile::open(own_), read_results(own_), descriptor, own_);
  const ResultFile before = ResultFile::open(path_), after = ResultFile::open(own_);
  int rows = 0;
  after.for_each_run([&](const RunRecord& run) {
    const auto first = before.read_run(run.scenario_hash, run.method, run.repetition);
    ASSERT_TRUE(first);
    EXPECT_EQ(run.metrics.at("time").value, first->metrics.at("time").value);
    const VersionedValue& comfort = run.metrics.at("comfort");
    EXPECT_EQ(comfort.version, 3);
    EXPECT_EQ(comfort.value, rows < 3 ? Value::of(7 + rows) : Value::na("asleep"));
    EXPECT_EQ(after.read_record(run.scenario_hash).descriptors.at("trees").value,
              Value::of(rows < 2 ? 11 : 12));
    EXPECT_EQ(after.read_scenario(run.scenario_hash).hash(), run.scenario_hash);
    EXPECT_EQ(after.read_trajectory(run).samples.size(), static_cast<std::size_t>(rows));
    EXPECT_EQ(after.read_timing(run).wall_seconds, ++rows);
    EXPECT_EQ(after.read_timing(run).output, "printed");
  });
  EXPECT_EQ(rows, 4);
  const Manifest manifest = after.read_manifest();
  EXPECT_EQ(manifest.at("own_column.comfort"), "f(x)");
  EXPECT_EQ(manifest.at("campaign"), "mine");
  EXPECT_TRUE(read_results(own_).damaged.empty());
}

TEST_F(OwnColumns, OfAnotherSizeIdOrRangeAreRefusedAndNothingIsWritten) {
  const auto refused = [&](std::initializer_list<std::string> words, const OwnColumn& column) {
    EXPECT_TRUE(mentions(error_text(ErrorKind::Usage, [&] { write(column, own_); }), words));
    EXPECT_FALSE(ResultFile::exists(own_));
  };
  refused({"comfort: has 3 values", "4, one per run"}, column_of("comfort", {1, 2, 3}));
  refused({"comfort of ", "/b/0: -1 is out of range", ">= 0"}, column_of("comfort", {1, 2, 3, -1}));
  for (const char* taken : {"time", "density"})
    refused({std::string(taken) + ": the results have a column of this id"},
            column_of(taken, {1, 2, 3, 4}));
  for (const char* id : {"", "Time", "2nd", "a b", "a\"", "_a"})
    refused({"cannot be the id of a column"}, column_of(id, {1, 2, 3, 4}));
  refused({"cannot be the id of a column"}, column_of(std::string(61, 'a'), {1, 2, 3, 4}));
}

}  // namespace
}  // namespace slalom
