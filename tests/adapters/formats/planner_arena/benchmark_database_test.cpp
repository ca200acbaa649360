// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/planner_arena/benchmark_database.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <unistd.h>

namespace slalom {
namespace {

constexpr const char* kIni =
    "[method.nd]\nadapter = mrpt_holonomic\n\n[simulation]\nmax_time = 60\n";

class BenchmarkDatabase : public testing::Test {
 protected:
  void SetUp() override {
    table_.manifest = {{"campaign.ini", kIni}, {"seed", "7"}, {"version.slalom", "1.2"}};
    table_.scenario_hashes = {"a", "b"};
    table_.scenario_names = {"scenario a", "scenario b"};
    table_.methods = {"gap", "nd"};
    table_.outcomes = {"success", "collision", "unsolvable_scenario"};
    table_.scenario = {0, 0, 1, 1};
    table_.method = {0, 1, 0, 1};
    table_.outcome = {0, 0, 0, 1};
    table_.repetition = {0, 0, 0, 0};
    table_.descriptors.emplace_back(QuantityInfo{"density", 1, "", "-", Direction::None});
    for (int scenario = 0; scenario < 2; ++scenario) table_.descriptors[0].add_number(0.2);
    for (const char* id : {"path_length", "time_to_goal", "cycle_time_mean"})
      table_.metrics.emplace_back(QuantityInfo{id, 1, "", "-", Direction::Down});
    table_.metrics[2].wall_clock = true;
    for (const std::uint32_t outcome : table_.outcome) {
      table_.metrics[0].add_number(4);
      table_.metrics[1].add(outcome == 0 ? Value::of(12.5) : Value::na("collision"));
      table_.metrics[2].add_number(1);
    }
    write_benchmark_database(table_, path_);
    database_ = std::make_unique<SQLite::Database>(path_, SQLite::OPEN_READONLY);
  }
  void TearDown() override { std::filesystem::remove(path_); }

  /// Rows of a query, fields joined by '|'.
  std::vector<std::string> rows(const std::string& sql) const {
    SQLite::Statement query(*database_, sql);
    std::vector<std::string> lines;
    while (query.executeStep()) {
      std::string line;
      for (int i = 0; i < query.getColumnCount(); ++i)
        line +=
            (i > 0 ? "|" : "") + (query.isColumnNull(i) ? "NULL" : query.getColumn(i).getString());
      lines.push_back(line);
    }
    return lines;
  }
  using Lines = std::vector<std::string>;

  const std::string path_ =
      testing::TempDir() + "slalom_planner_arena_" + std::to_string(getpid()) + ".db";
  ResultTable table_;
  std::unique_ptr<SQLite::Database> database_;
};

TEST_F(BenchmarkDatabase, SupportsTheQueryDocumentedByOmpl) {
  EXPECT_EQ(rows("SELECT REPLACE(plannerConfigs.name, 'geometric_', '') AS name, runs.solved, "
                 "runs.time, runs.path_length FROM plannerConfigs INNER JOIN runs ON "
                 "plannerConfigs.id = runs.plannerid ORDER BY runs.id"),
            (Lines{"gap|1|12.5|4.0", "nd|1|12.5|4.0", "gap|1|12.5|4.0", "nd|0|NULL|4.0"}));
}

TEST_F(BenchmarkDatabase, HasTheColumnTypesThatPlannerArenaExpects) {
  EXPECT_EQ(rows("SELECT name, type FROM pragma_table_info('runs')"),
            (Lines{"id|INTEGER", "experimentid|INTEGER", "plannerid|INTEGER", "time|REAL",
                   "solved|BOOLEAN", "status|ENUM", "path_length|REAL", "time_to_goal|REAL"}));
}

TEST_F(BenchmarkDatabase, StoresOutcomesAsAnEnum) {
  EXPECT_EQ(rows("SELECT enums.description, COUNT(*) FROM runs JOIN enums ON enums.name = 'status' "
                 "AND enums.value = runs.status GROUP BY 1 ORDER BY 1"),
            (Lines{"collision|1", "success|3"}));
}

TEST_F(BenchmarkDatabase, ARunThatSaysNothingAboutTheMethodIsNeitherSolvedNorUnsolved) {
  table_.outcome[3] = 2;
  write_benchmark_database(table_, path_);
  database_ = std::make_unique<SQLite::Database>(path_, SQLite::OPEN_READONLY);
  EXPECT_EQ(rows("SELECT solved FROM runs ORDER BY id"), (Lines{"1", "1", "1", "NULL"}));
}

TEST_F(BenchmarkDatabase, StoresEachScenarioAsAnExperiment) {
  EXPECT_EQ(rows("SELECT name, timelimit, memorylimit, runcount, version, seed, density FROM "
                 "experiments ORDER BY id"),
            (Lines{"scenario a|60.0|NULL|2|Slalom 1.2|7|0.2",
                   "scenario b|60.0|NULL|2|Slalom 1.2|7|0.2"}));
}

TEST_F(BenchmarkDatabase, StoresTheSettingsOfEachMethod) {
  EXPECT_EQ(rows("SELECT name, settings FROM plannerConfigs ORDER BY id"),
            (Lines{"gap|", "nd|adapter = mrpt_holonomic;"}));
}

TEST_F(BenchmarkDatabase, HasValidReferences) {
  EXPECT_TRUE(rows("PRAGMA foreign_key_check").empty());
  EXPECT_EQ(rows("SELECT COUNT(*) FROM progress"), (Lines{"0"}));
}

TEST_F(BenchmarkDatabase, ReplacesAnExistingFileOrReportsAnError) {
  table_.scenario.pop_back();
  write_benchmark_database(table_, path_);
  database_ = std::make_unique<SQLite::Database>(path_, SQLite::OPEN_READONLY);
  EXPECT_EQ(rows("SELECT COUNT(*) FROM runs"), (Lines{"3"}));
  EXPECT_THROW(write_benchmark_database(table_, testing::TempDir() + "slalom_none/x.db"), Error);
}

}  // namespace
}  // namespace slalom
