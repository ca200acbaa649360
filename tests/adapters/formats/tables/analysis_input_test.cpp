// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "temporary_folder.h"

#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/metrics/metric.h>
#include <slalom/results/outcome_words.h>
#include <slalom/tables/analysis_input.h>
#include <slalom/trajectory/trajectory.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <map>

namespace slalom {
namespace {

class AnalysisInput : public testing::Test {
 protected:
  const TemporaryFolder folder_;
};

TEST_F(AnalysisInput, AnyTextIsATableUnlessItsNameIsThatOfResults) {
  const std::string table = "method,cost\na,1\nb,2\n";
  write_file_atomically(folder_ / "trials.csv", table);
  write_file_atomically(folder_ / "out.txt", table);
  write_file_atomically(folder_ / "trials.results", table);
  EXPECT_EQ(read_analysis_input(folder_ / "trials.csv", std::nullopt, false, {}).size(), 2U);
  EXPECT_EQ(read_analysis_input(folder_ / "out.txt", std::nullopt, false, {}).size(), 2U);
  EXPECT_EQ(read_analysis_input(folder_ / "trials.results", std::nullopt, true, {}).size(), 2U);
  EXPECT_TRUE(throws_error(ErrorKind::File, folder_ / "trials.results", {}, [&] {
    read_analysis_input(folder_ / "trials.results", std::nullopt, false, {});
  }));
}

TEST_F(AnalysisInput, AByteOrderMarkIsNotPartOfTheFirstName) {
  write_file_atomically(folder_ / "trials.csv", "\xEF\xBB\xBFmethod,cost\na,1\nb,2\n");
  EXPECT_EQ(read_analysis_input(folder_ / "trials.csv", std::nullopt, false, {}).methods,
            (std::vector<std::string>{"a", "b"}));
}

TEST_F(AnalysisInput, ColumnsOfTablesWithTheIdOfAMetricHaveItsRange) {
  const std::string path = folder_ / "trials.csv";
  write_file_atomically(path, "method,spl,optimality,cost\na,0.5,90%,1.5\nb,0.9,85%,2\n");
  const ResultTable table = read_analysis_input(path, std::nullopt, false, {});
  EXPECT_EQ(range_notation(find_metric(table, "spl")->info().range), "0..1");
  EXPECT_EQ(range_notation(find_metric(table, "optimality")->info().range), "0..1");
  EXPECT_EQ(range_notation(find_metric(table, "cost")->info().range), "..");
  write_file_atomically(path, "method,optimality\na,90\n");
  EXPECT_TRUE(throws_error(ErrorKind::File, path + ":2",
                           {"'optimality' is 90", "in [0, 1]", "--range optimality="},
                           [&] { read_analysis_input(path, std::nullopt, false, {}); }));
}

TEST_F(AnalysisInput, MetricsOfTheGoalAreNotAvailableInFailedRunsOfTables) {
  const std::string path = folder_ / "trials.csv";
  write_file_atomically(path, "success,time_to_goal,path_length,spl\n1,5,4,0.8\n0,60,3,0\n");
  const ResultTable table = read_analysis_input(path, std::nullopt, false, {});
  EXPECT_TRUE(find_metric(table, "time_to_goal")->is_na(1));
  EXPECT_TRUE(find_metric(table, "path_length")->is_na(1));
  EXPECT_EQ(find_metric(table, "spl")->number(1), 0);
}

TEST_F(AnalysisInput, EachOutcomeOfARunIsAWordOfTables) {
  for (const std::string& name : names_of<Outcome>()) EXPECT_EQ(outcome_of_word(name), name);
}

/// Tables as ompl_benchmark_statistics.py makes them, with a run of each kind.
TEST_F(AnalysisInput, ReadsBenchmarkDatabasesOfOmpl) {
  const std::string path = folder_ / "benchmark.db";
  SQLite::Database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(R"(
CREATE TABLE experiments (id INTEGER PRIMARY KEY, name VARCHAR(512), totaltime REAL);
CREATE TABLE plannerConfigs (id INTEGER PRIMARY KEY, name VARCHAR(512) NOT NULL, settings TEXT);
CREATE TABLE enums (name VARCHAR(512), value INTEGER, description TEXT);
CREATE TABLE runs (id INTEGER PRIMARY KEY, experimentid INTEGER, plannerid INTEGER, time REAL,
  "solution length" REAL, solved BOOLEAN, status ENUM, "graph states" INTEGER);
INSERT INTO experiments VALUES (1, 'maze, small', 60), (2, 'cubicles', 60);
INSERT INTO plannerConfigs VALUES (1, 'geometric_RRT', ''), (2, 'geometric_PRM', '');
INSERT INTO enums VALUES ('status', 3, 'Timeout'), ('status', 6, 'Approximate solution'),
  ('status', 7, 'Exact solution');
INSERT INTO runs VALUES (1, 1, 1, 0.5, 12.25, 1, 7, 100), (2, 1, 2, 0.75, 14, 1, 6, 200),
  (3, 1, 1, 1.5, 11, 1, 7, 300), (4, 2, 9, 20, NULL, 0, 3, 400);
)");
  const ResultTable table = read_analysis_input(path, std::nullopt, false, {});
  EXPECT_EQ(table.methods,
            (std::vector<std::string>{"geometric_PRM", "geometric_RRT", "planner 9"}));
  EXPECT_EQ(table.scenario_names, (std::vector<std::string>{"maze, small", "cubicles"}));
  EXPECT_EQ(table.outcomes, (std::vector<std::string>{"success", "failure", "timeout"}));
  ASSERT_EQ(table.size(), 4U);
  double length = 0, states = 0;
  int missing = 0, successes = 0, second = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const ValueColumn* lengths = find_metric(table, "solution_length");
    ASSERT_NE(lengths, nullptr);
    lengths->is_na(i) ? void(++missing) : void(length += lengths->number(i));
    states += find_metric(table, "graph_states")->number(i);
    successes += table.outcomes[table.outcome[i]] == "success" ? 1 : 0;
    second += table.repetition[i] == 1 ? 1 : 0;
  }
  EXPECT_EQ(length, 12.25 + 11) << "of exact solutions";
  EXPECT_EQ(states, 1000);
  EXPECT_EQ(missing, 2);
  EXPECT_EQ(successes, 2) << "an approximate solution does not reach the goal";
  EXPECT_EQ(second, 1) << "of RRT in the maze";
}

TEST_F(AnalysisInput, RefusesDamagedBenchmarkDatabases) {
  const std::string path = folder_ / "benchmark.db";
  SQLite::Database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec(
          "CREATE TABLE plannerConfigs (id); CREATE TABLE experiments (id); "
          "CREATE TABLE enums (name, value, description); CREATE TABLE runs (id)");
  EXPECT_TRUE(throws_error(ErrorKind::File, path, {"no such column", "database of OMPL"},
                           [&] { read_analysis_input(path, std::nullopt, false, {}); }));
}

TEST_F(AnalysisInput, ReadsResultsOfBenchMr) {
  const std::string path = folder_ / "results.json";
  write_file_atomically(path, R"({"settings": {}, "runs": [
{"environment": {"name": "corridor"}, "plans": {
  "RRT": {"stats": {"path_found": true, "path_collides": false, "exact_goal_path": true,
                    "path_length": 10.5, "cusps": [[1, 2], [3, 4]], "planner": "RRT"}},
  "SBPL": {"stats": {"path_found": true, "path_collides": true, "exact_goal_path": true,
                     "path_length": 9, "cusps": []}}}},
{"environment": {"name": "corridor"}, "plans": {
  "RRT": {"stats": {"path_found": false, "path_collides": false, "exact_goal_path": false,
                    "path_length": null, "cusps": null}},
  "SBPL": {"stats": null}}}]})");
  const ResultTable table = read_analysis_input(path, std::nullopt, false, {});
  EXPECT_EQ(table.methods, (std::vector<std::string>{"RRT", "SBPL"}));
  EXPECT_EQ(table.scenario_names, (std::vector<std::string>{"corridor 0", "corridor 1"}));
  ASSERT_EQ(table.size(), 4U) << "also the plan without stats";
  std::map<std::string, int> outcomes;
  for (const std::uint32_t outcome : table.outcome) ++outcomes[table.outcomes[outcome]];
  EXPECT_EQ(outcomes,
            (std::map<std::string, int>{{"collision", 1}, {"failure", 2}, {"success", 1}}));
  EXPECT_EQ(find_metric(table, "cusps")->number(0), 2);
  for (const std::string damaged :
       {R"({"runs": [{"plans": 3}]})", R"({"runs": [{"plans": {}}, 3]})", R"({"runs": {}})",
        R"({"runs": [)"}) {
    write_file_atomically(path, damaged);
    EXPECT_THROW(read_analysis_input(path, std::nullopt, false, {}), Error) << damaged;
  }
}

TEST_F(AnalysisInput, ResultFilesAreReadAsSuchWhateverTheirName) {
  const std::string path = folder_ / "runs.csv";
  ResultFile::create(path, {{"campaign", "test"}}, {}, {});
  EXPECT_EQ(read_analysis_input(path, std::nullopt, true, {}).manifest.at("campaign"), "test");
}

TEST_F(AnalysisInput, IndexesBecomeTheirEdges) {
  const std::string path = folder_ / "a.scenarios";
  ScenarioList::create(path).create_index(
      {"by_density", "density", {{"density", 1, ""}}, {0, 0.25, 1}});
  const auto specs = resolve_indexes(parse_bin_specs("all;density:@by_density"), path);
  ASSERT_EQ(specs.size(), 2U);
  EXPECT_EQ(specs[0].kind, BinSpec::Kind::All);
  EXPECT_EQ(specs[1].kind, BinSpec::Kind::Edges);
  EXPECT_EQ(specs[1].edges, (std::vector<double>{0, 0.25, 1}));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "rows 'density:@by_density'", {"--scenarios"},
                           [] { resolve_indexes(parse_bin_specs("density:@by_density"), ""); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "rows 'clearness:@by_density'", {"density"}, [&] {
    resolve_indexes(parse_bin_specs("clearness:@by_density"), path);
  }));
}

TEST(KnownQuantities, HaveDifferentIds) {
  for (const std::string& id : descriptor_ids()) EXPECT_FALSE(contains(metric_ids(), id)) << id;
}

TEST(KnownQuantities, ContainTheSuccessThatTablesDeriveFromTheOutcome) {
  const QuantityInfo &registered = metric("success").info, derived = success_info();
  EXPECT_EQ(registered.id, derived.id);
  EXPECT_EQ(registered.version, derived.version);
  EXPECT_EQ(registered.name, derived.name);
  EXPECT_EQ(registered.unit, derived.unit);
  EXPECT_EQ(registered.direction, derived.direction);
  EXPECT_EQ(registered.kind, derived.kind);
  EXPECT_EQ(range_notation(registered.range), range_notation(derived.range));
}

}  // namespace
}  // namespace slalom
