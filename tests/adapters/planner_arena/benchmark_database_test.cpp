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

RunRecord run_of(const std::string& scenario, const std::string& method,
                 const std::string& outcome) {
  RunRecord run;
  run.scenario_hash = scenario;
  run.scenario_name = "place " + scenario;
  run.method = method;
  run.outcome = outcome;
  const bool reached = outcome == "success";
  run.metrics["time_to_goal"] = {1, reached ? Value::of(12.5) : Value::na(outcome)};
  run.metrics["path_length"] = {1, Value::of(4)};
  return run;
}

class BenchmarkDatabase : public testing::Test {
 protected:
  void SetUp() override {
    table_.manifest = {{"campaign.ini", kIni}, {"seed", "7"}, {"version.slalom", "1.2"}};
    for (const char* hash : {"a", "b"})
      table_.scenarios[hash] = {
          hash, std::string("place ") + hash, {{"density", {1, Value::of(0.2)}}}};
    for (const char* hash : {"a", "b"}) {
      table_.runs.push_back(run_of(hash, "gap", "success"));
      table_.runs.push_back(run_of(hash, "nd", *hash == 'a' ? "success" : "collision"));
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

TEST_F(BenchmarkDatabase, AnswersTheQueryThatOmplDocuments) {
  EXPECT_EQ(rows("SELECT REPLACE(plannerConfigs.name, 'geometric_', '') AS name, runs.solved, "
                 "runs.time, runs.path_length FROM plannerConfigs INNER JOIN runs ON "
                 "plannerConfigs.id = runs.plannerid ORDER BY runs.id"),
            (Lines{"gap|1|12.5|4.0", "nd|1|12.5|4.0", "gap|1|12.5|4.0", "nd|0|NULL|4.0"}));
}

TEST_F(BenchmarkDatabase, GivesTheColumnsTheTypesThatPlannerArenaTellsPlotsBy) {
  EXPECT_EQ(rows("SELECT name, type FROM pragma_table_info('runs')"),
            (Lines{"id|INTEGER", "experimentid|INTEGER", "plannerid|INTEGER", "time|REAL",
                   "solved|BOOLEAN", "status|ENUM", "path_length|REAL", "time_to_goal|REAL"}));
}

TEST_F(BenchmarkDatabase, NamesOutcomesByAnEnum) {
  EXPECT_EQ(rows("SELECT enums.description, COUNT(*) FROM runs JOIN enums ON enums.name = 'status' "
                 "AND enums.value = runs.status GROUP BY 1 ORDER BY 1"),
            (Lines{"collision|1", "success|3"}));
}

TEST_F(BenchmarkDatabase, MakesAnExperimentOfEachScenario) {
  EXPECT_EQ(
      rows("SELECT name, timelimit, memorylimit, runcount, version, seed, density FROM "
           "experiments ORDER BY id"),
      (Lines{"place a|60.0|NULL|2|Slalom 1.2|7|0.2", "place b|60.0|NULL|2|Slalom 1.2|7|0.2"}));
}

TEST_F(BenchmarkDatabase, KeepsTheSettingsOfEachMethod) {
  EXPECT_EQ(rows("SELECT name, settings FROM plannerConfigs ORDER BY id"),
            (Lines{"gap|", "nd|adapter = mrpt_holonomic;"}));
}

TEST_F(BenchmarkDatabase, HasNoBrokenReferences) {
  EXPECT_TRUE(rows("PRAGMA foreign_key_check").empty());
  EXPECT_EQ(rows("SELECT COUNT(*) FROM progress"), (Lines{"0"}));
}

TEST_F(BenchmarkDatabase, ReplacesWhatWasThereOrSaysWhyNot) {
  table_.runs.pop_back();
  write_benchmark_database(table_, path_);
  database_ = std::make_unique<SQLite::Database>(path_, SQLite::OPEN_READONLY);
  EXPECT_EQ(rows("SELECT COUNT(*) FROM runs"), (Lines{"3"}));
  EXPECT_THROW(write_benchmark_database(table_, testing::TempDir() + "slalom_none/x.db"), Error);
}

}  // namespace
}  // namespace slalom
