#include "run_data.h"
#include "run_pages.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <unistd.h>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// A scenario with one run, written to a result file of its own.
class RunPagesTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("slalom_run_pages_" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "report");
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Calls `check` with pages of one run over `samples` samples, a tenth of a second and of a metre
  /// apart.
  template <typename Check>
  void with_pages(const Scenario& scenario, std::size_t samples, Check check) {
    ResultFile file = ResultFile::create((folder_ / "runs.results").string(), {}, {}, {kLength});
    const ScenarioRecord record{scenario.hash(), scenario.name(), {}};
    file.add_scenario(record, scenario, {});
    RunRecord run;
    run.scenario_hash = scenario.hash();
    run.scenario_name = scenario.name();
    run.method = "nd & co";
    run.outcome = "stuck";
    run.metrics["path_length"] = {1, Value::na("</script> it stood still")};
    Trajectory trajectory;
    for (std::size_t i = 0; i < samples; ++i) {
      Sample sample;
      sample.t = 0.1 * static_cast<double>(i);
      sample.pose = {1 + 0.1 * static_cast<double>(i), 1, 0};
      trajectory.samples.push_back(sample);
    }
    file.add_run(run, {}, trajectory);
    file.commit();
    const ResultTable table = file.read_table();
    const std::vector<Column> columns = resolve_columns(table, {"success", "path_length"});
    const std::vector<RunGroup> groups = {{"a cell", {0}}};
    check(RunPages{file, table, columns, groups, {}, {}, {}, 0.5});
  }

  static Scenario room() {
    return Scenario::continuous("room", {0, 0, 30, 10}, {{{{5, 5}, 0.5}}, {}}, {1, 1, 0}, {9, 9});
  }

  /// What a script hands to its function.
  static nlohmann::json argument(const std::string& script, const std::string& function) {
    EXPECT_EQ(script.rfind(function + "(", 0), 0u) << script.substr(0, 40);
    const std::size_t from = function.size() + 1;
    return nlohmann::json::parse(script.substr(from, script.rfind(")") - from));
  }

  static std::vector<std::int64_t> sums(const nlohmann::json& differences) {
    std::vector<std::int64_t> numbers;
    std::int64_t sum = 0;
    for (const std::int64_t difference : differences) numbers.push_back(sum += difference);
    return numbers;
  }

  const RunNames kNames = {{"path_length"}, {"nd & co"}};
  const QuantityInfo kLength = {"path_length", 1, "Path length", "m", Direction::Down};
  fs::path folder_;
};

TEST_F(RunPagesTest, KeepTrajectoriesInThousandths) {
  with_pages(room(), 3, [&](const RunPages& pages) {
    const auto data = argument(scenario_script(pages, kNames, pages.table.scenarios.begin()->second,
                                               {0}, folder_.string()),
                               "slalomScenario");
    const auto& run = data["runs"][0];
    EXPECT_EQ(sums(run["t"]), (std::vector<std::int64_t>{0, 100, 200}));
    EXPECT_EQ(sums(run["x"]), (std::vector<std::int64_t>{1000, 1100, 1200}));
    EXPECT_EQ(sums(run["y"]), (std::vector<std::int64_t>{1000, 1000, 1000}));
    // The border is nearest: 1 m below the centre, less the robot's radius of 0.25 m.
    EXPECT_EQ(sums(run["c"]).front(), 750);
    EXPECT_EQ(data["discs"][0], (nlohmann::json{5.0, 5.0, 0.5}));
    EXPECT_EQ(data["reasons"][run["values"][0][0].get<int>()], "</script> it stood still");
  });
}

TEST_F(RunPagesTest, KeepFirstAndLastOfLongTrajectories) {
  const std::size_t n = 10 * kMostSamples;
  with_pages(room(), n, [&](const RunPages& pages) {
    const auto data = argument(scenario_script(pages, kNames, pages.table.scenarios.begin()->second,
                                               {0}, folder_.string()),
                               "slalomScenario");
    const auto times = sums(data["runs"][0]["t"]);
    ASSERT_EQ(times.size(), kMostSamples);
    EXPECT_EQ(times.front(), 0);
    EXPECT_EQ(times.back(), static_cast<std::int64_t>(100 * (n - 1)));
  });
}

TEST_F(RunPagesTest, GiveGridsAsRunLengths) {
  // Two rows of three cells of 1 m: ". # #" below, "# . ." above.
  mrpt::maps::COccupancyGridMap2D map(0, 3, 0, 2, 1);
  for (int x = 0; x < 3; ++x) {
    map.setCell(x, 0, x == 0 ? 1.0f : 0.0f);
    map.setCell(x, 1, x == 0 ? 0.0f : 1.0f);
  }
  with_pages(Scenario::grid("grid", map, {0.5, 0.5, 0}, {2.5, 1.5}), 1, [&](const RunPages& pages) {
    const auto data = argument(scenario_script(pages, kNames, pages.table.scenarios.begin()->second,
                                               {0}, folder_.string()),
                               "slalomScenario");
    EXPECT_EQ(data["grid"]["runs"], (nlohmann::json{1, 3, 2}));
    EXPECT_EQ(data["grid"]["nx"], 3);
  });
}

TEST_F(RunPagesTest, ListEveryRunAndEveryGroup) {
  with_pages(room(), 2, [&](const RunPages& pages) {
    const auto runs = argument(runs_script(pages), "slalomRuns");
    EXPECT_EQ(runs["runs"], nlohmann::json::parse("[[0, 0, 0, 0, 0.0, null]]"));
    EXPECT_EQ(runs["methods"][0], "nd & co");
    EXPECT_EQ(runs["columns"], (nlohmann::json{"success", "path_length"}));
    const auto cells = argument(cells_script(pages), "slalomCells");
    EXPECT_EQ(cells, nlohmann::json::parse(R"([{"title": "a cell", "runs": [0]}])"));
  });
}

TEST_F(RunPagesTest, LinkARawlogWhereThereIsOne) {
  with_pages(room(), 2, [&](const RunPages& pages) {
    const std::string report = (folder_ / "report").string();
    const ScenarioRecord& scenario = pages.table.scenarios.begin()->second;
    EXPECT_NE(scenario_script(pages, kNames, scenario, {0}, report).find("\"rawlog\":\"\""),
              std::string::npos);
  });
}

TEST_F(RunPagesTest, StandInOneFolderWithAllTheyLoad) {
  with_pages(room(), 2, [&](const RunPages& pages) {
    write_run_pages(pages, (folder_ / "report").string());
    const std::string id = pages.table.runs[0].scenario_hash.substr(0, 8);
    for (const std::string& name :
         {std::string("run.html"), std::string("runs.html"), std::string("run.js"),
          std::string("runs.js"), std::string("data/runs.js"), std::string("data/cells.js"),
          std::string("data/metrics.js"), "data/s-" + id + ".js"})
      EXPECT_TRUE(fs::exists(folder_ / "report" / name)) << name;
    EXPECT_EQ(run_link(pages.table.runs[0]), "run.html#" + id + "/nd%20%26%20co/0");
  });
}

}  // namespace
}  // namespace slalom
