// SPDX-License-Identifier: BSD-3-Clause
#include "dump_text.h"
#include "io_sample.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace slalom {
namespace {

const std::vector<QuantityInfo> kDescriptors = {{"density", 1, "Density", "-", Direction::None}};
const std::vector<QuantityInfo> kMetrics = {success_info(),
                                            {"optimality", 3, "Optimality", "-", Direction::Up}};

RunRecord run_of(const Scenario& scenario, const std::string& method, int repetition) {
  RunRecord run;
  run.scenario_hash = scenario.hash();
  run.scenario_name = scenario.name();
  run.method = method;
  run.repetition = repetition;
  run.seed = 0xfedcba9876543210ULL;
  run.outcome = "collision";
  run.outcome_detail = "contact at \"(1, 2)\"";
  run.trajectory_hash = Trajectory().hash();
  run.metrics["success"] = {1, Value::of(0)};
  run.metrics["optimality"] = {3, Value::na("outcome: collision")};
  return run;
}

class ResultFileTest : public testing::Test {
 protected:
  ResultFile create(const std::string& name) {
    return ResultFile::create(folder_ / name, {{"campaign", "test"}, {"seed", "1"}}, kDescriptors,
                              kMetrics);
  }

  TemporaryFolder folder_;
  Scenario scenario_ = sample_scenario(1);
};

TEST_F(ResultFileTest, RestoresAllData) {
  References references;
  references.shortest = ShortestPath{{{0, 0}, {3, 4}}, 5, {4.9, 5}, "BITstar", "note", 5.1, 5.0};
  references.timing = {0.1, 0.2, 0.3};
  references.safest_reason = "too narrow";
  Trajectory trajectory;
  for (int i = 0; i < 10; ++i)
    trajectory.samples.push_back({0.1 * i, {std::sqrt(i), 2, 3}, 4, 5, 6, 7});
  RunRecord run = run_of(scenario_, "nd", 2);
  run.trajectory_hash = trajectory.hash();
  run.metrics["optimality"].value = Value::of(0.1 + 0.2, 0.01);
  {
    ResultFile file = create("a.results");
    file.add_scenario(
        {scenario_.hash(), scenario_.name(), {{"density", {1, Value::of(0.1, 1e-3)}}}}, scenario_,
        references);
    file.add_run(run, {1.5, {{"cycle_time_mean", 0.25}}, "printed\n\xff"}, trajectory);
    file.commit();
  }
  const ResultFile file = ResultFile::open(folder_ / "a.results");
  EXPECT_EQ(file.read_manifest().at("campaign"), "test");
  EXPECT_EQ(file.metrics().at(1).version, 3);
  EXPECT_EQ(file.metrics().at(0).direction, Direction::Up);
  EXPECT_EQ(file.descriptors().at(0).id, "density");
  const ScenarioRecord record = file.read_record(scenario_.hash());
  EXPECT_EQ(record.name, scenario_.name());
  EXPECT_EQ(record.descriptors.at("density").value, Value::of(0.1, 1e-3));
  ASSERT_EQ(file.read_runs(scenario_.hash()).size(), 1U);
  ASSERT_TRUE(file.read_run(scenario_.hash(), "nd", 2));
  const RunRecord restored = *file.read_run(scenario_.hash(), "nd", 2);
  EXPECT_EQ(restored.seed, run.seed);
  EXPECT_EQ(restored.outcome_detail, run.outcome_detail);
  EXPECT_EQ(restored.metrics.at("optimality").value, Value::of(0.1 + 0.2, 0.01));
  EXPECT_EQ(restored.metrics.at("optimality").version, 3);
  EXPECT_EQ(file.read_timing(restored).wall_seconds, 1.5);
  EXPECT_EQ(file.read_timing(restored).values.at("cycle_time_mean"), 0.25);
  EXPECT_EQ(file.read_timing(restored).output, "printed\n\xff");
  EXPECT_EQ(file.read_trajectory(restored).hash(), trajectory.hash());
  EXPECT_EQ(file.read_scenario(scenario_.hash()).hash(), scenario_.hash());
  const References refs = file.read_references(scenario_.hash());
  ASSERT_TRUE(refs.shortest.has_value());
  EXPECT_EQ(refs.shortest->certificate.lower_bound, 4.9);
  EXPECT_EQ(refs.shortest->planner, "BITstar");
  EXPECT_EQ(refs.shortest->exact_length, 5.1);
  EXPECT_EQ(refs.shortest->planner_length, 5.0);
  EXPECT_EQ(refs.timing.safest, 0.3);
  EXPECT_EQ(refs.safest_reason, "too narrow");
}

TEST_F(ResultFileTest, FindsTheColumnsOfRunsByTheirNames) {
  const std::string path = folder_ / "a.results";
  {
    ResultFile file = create("a.results");
    file.add_scenario({scenario_.hash(), scenario_.name(), {}}, scenario_, {});
    file.add_run(run_of(scenario_, "nd", 2), {}, {});
    file.commit();
  }
  const std::string lines = dump_text(ResultFile::open(path));
  SQLite::Database(path, SQLite::OPEN_READWRITE)
      .exec(
          "CREATE TABLE reversed AS SELECT checksum, m_optimality, m_success, standard_errors, "
          "reasons, trajectory_hash, outcome_detail, outcome, seed, repetition, method, "
          "scenario_name, scenario, run FROM runs; "
          "DROP TABLE runs; ALTER TABLE reversed RENAME TO runs");
  EXPECT_EQ(dump_text(ResultFile::open(path)), lines);
  const ResultTable table = read_results(path);
  EXPECT_TRUE(table.damaged.empty());
  ASSERT_EQ(table.size(), 1U);
  EXPECT_EQ(find_metric(table, "optimality")->reason(0), "outcome: collision");
}

TEST_F(ResultFileTest, ReadsTheRunsOfOneScenario) {
  const Scenario other = sample_scenario(2, "other");
  {
    ResultFile file = create("a.results");
    for (const Scenario& scenario : {scenario_, other})
      file.add_scenario({scenario.hash(), scenario.name(), {}}, scenario, {});
    for (const char* method : {"vfh", "nd"})
      for (const int repetition : {1, 0}) file.add_run(run_of(other, method, repetition), {}, {});
    file.add_run(run_of(scenario_, "ptg", 0), {}, {});
    file.commit();
  }
  const ResultFile file = ResultFile::open(folder_ / "a.results");
  EXPECT_EQ((std::vector<std::string>{"nd", "ptg", "vfh"}), file.read_methods());
  EXPECT_EQ("test", file.read_manifest().at("campaign"));
  EXPECT_TRUE(file.has_scenario(other.hash()));
  EXPECT_FALSE(file.has_scenario("00"));
  EXPECT_TRUE(file.read_runs("00").empty());
  EXPECT_FALSE(file.read_run(other.hash(), "nd", 2));
  EXPECT_TRUE(file.read_record("00").descriptors.empty());
  std::vector<std::string> ids;
  for (const RunRecord& run : file.read_runs(other.hash())) {
    EXPECT_EQ("other", run.scenario_name);
    EXPECT_EQ("outcome: collision", run.metrics.at("optimality").value.reason());
    ids.push_back(run.method + std::to_string(run.repetition));
  }
  EXPECT_EQ((std::vector<std::string>{"nd0", "nd1", "vfh0", "vfh1"}), ids);
}

TEST_F(ResultFileTest, RunsAreSortedIndependentlyOfInsertionOrder) {
  {
    ResultFile file = create("a.results");
    for (const char* method : {"z", "a"})
      for (const int repetition : {1, 0})
        file.add_run(run_of(scenario_, method, repetition), {}, {});
    file.commit();
  }
  std::vector<std::string> ids;
  ResultFile::open(folder_ / "a.results").for_each_run([&](const RunRecord& run) {
    ids.push_back(run.method + std::to_string(run.repetition));
  });
  EXPECT_EQ(ids, (std::vector<std::string>{"a0", "a1", "z0", "z1"}));
}

/// They come from a process in which a method ran.
TEST_F(ResultFileTest, FiguresWithNamesThatAreNotUtf8AreStored) {
  ResultFile file = create("a.results");
  const RunRecord run = run_of(scenario_, "nd", 0);
  file.add_run(run, {1.5, {{"caf\xe9", 2}, {"cycle_time_mean", 3}}}, Trajectory());
  ASSERT_TRUE(file.commit());
  EXPECT_EQ(file.read_timing(run).values.at("cycle_time_mean"), 3);
}

TEST_F(ResultFileTest, DropsUncommittedRuns) {
  {
    ResultFile file = create("a.results");
    file.add_run(run_of(scenario_, "nd", 0), {}, {});
    file.commit();
    file.add_run(run_of(scenario_, "nd", 1), {}, {});
  }
  EXPECT_EQ(ResultFile::open(folder_ / "a.results").read_runs(scenario_.hash()).size(), 1U);
}

TEST_F(ResultFileTest, RejectsInvalidFilesPathsAndColumnNames) {
  EXPECT_THROW(ResultFile::open(folder_ / "missing"), Error);
  EXPECT_THROW(create("no/such/folder/a.results"), Error);
  write_file_atomically(folder_ / "b", std::string(4096, 'x'));
  EXPECT_THROW(ResultFile::open(folder_ / "b"), Error);
  const std::vector<QuantityInfo> too_long = {{std::string(1001, 'x'), 1, "", "", {}}};
  EXPECT_THROW(ResultFile::create(folder_ / "c", {}, {}, too_long), Error);
}

TEST_F(ResultFileTest, DumpIsOneLineOfSortedKeysWithoutWallClock) {
  const ScenarioRecord record{scenario_.hash(), "sample", {{"density", {1, Value::of(0.25)}}}};
  const std::string line = dump_line("c", record, run_of(scenario_, "nd", 0));
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const auto json = nlohmann::json::parse(line);
  EXPECT_EQ(json.dump(), line) << "keys must be sorted";
  EXPECT_EQ(json["metrics"]["optimality"]["na"], "outcome: collision");
  EXPECT_EQ(json["metrics"]["success"]["value"], 0);
  EXPECT_EQ(json["descriptors"]["density"]["value"], 0.25);
  EXPECT_EQ(json["scenario"]["hash"], scenario_.hash());
  EXPECT_EQ(json["seed"], 0xfedcba9876543210ULL);
}

TEST_F(ResultFileTest, DumpIsSortedAndHasTheDescriptorsOfEachScenario) {
  const Scenario first = sample_scenario(2, "a"), second = sample_scenario(3, "b");
  ResultFile file = create("a.results");
  file.add_scenario({second.hash(), "b", {{"density", {1, Value::of(0.5)}}}}, second, {});
  file.add_scenario({first.hash(), "a", {{"density", {1, Value::na("none")}}}}, first, {});
  for (const Scenario& scenario : {second, first})
    for (const int repetition : {1, 0}) file.add_run(run_of(scenario, "nd", repetition), {}, {});
  std::string expected;
  for (const Scenario& scenario : {first, second})
    for (const int repetition : {0, 1})
      expected +=
          dump_line("test", file.read_record(scenario.hash()), run_of(scenario, "nd", repetition)) +
          "\n";
  EXPECT_EQ(dump_text(file), expected);
}

TEST(Files, AreReplacedAtomically) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "a", "one");
  write_file_atomically(folder / "a", "two");
  EXPECT_EQ(read_file(folder / "a"), "two");
  EXPECT_THROW(write_file_atomically(folder / "no/a", "x"), Error);
  EXPECT_THROW(read_file(folder / "missing"), Error);
}

TEST(Files, RemainAsTheyWereIfTheirWriterThrows) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "a", "one");
  const auto fails = [](std::ostream& out) {
    out << "two";
    throw std::runtime_error("no more");
  };
  EXPECT_THROW(write_file_atomically(folder / "a", fails), std::runtime_error);
  EXPECT_EQ(read_file(folder / "a"), "one");
  const std::filesystem::directory_iterator files(
      std::filesystem::path(folder / "a").parent_path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

}  // namespace
}  // namespace slalom
