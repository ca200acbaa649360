// SPDX-License-Identifier: BSD-3-Clause
#include "memory_folder.h"
#include "scenario_data.h"

#include <slalom/io/rawlog_path.h>
#include <slalom/io/read_results.h>
#include <slalom/metrics/metric.h>
#include <slalom/simulation/evaluate_trajectory.h>

#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// A result file with one scenario and one run.
class ScenarioData : public testing::Test {
 protected:
  ScenarioData() {
    std::string pattern = (memory_folder() / "slalom_scenario_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~ScenarioData() override { fs::remove_all(folder_); }

  /// The data of a scenario with one run of `samples` samples, 0.1 s and 0.1 m apart.
  nlohmann::json data_of(const Scenario& scenario, std::size_t samples) const {
    Trajectory trajectory;
    for (std::size_t i = 0; i < samples; ++i) {
      const double t = 0.1 * static_cast<double>(i);
      trajectory.samples.push_back({t, {1 + t, 1, 0}});
    }
    return data_of(scenario, trajectory);
  }

  /// The data of a scenario with one run.
  nlohmann::json data_of(const Scenario& scenario, const Trajectory& trajectory) const {
    const std::string path = (folder_ / "runs.results").string();
    ResultFile file = ResultFile::create(path, {}, {}, {kLength});
    file.add_scenario({scenario.hash(), scenario.name(), {}}, scenario, {});
    RunRecord run;
    run.scenario_hash = scenario.hash();
    run.scenario_name = scenario.name();
    run.method = "nd & co";
    run.seed = 18446744073709551615u;
    run.outcome = "stuck";
    run.metrics["path_length"] = {1, Value::na("</script> stopped")};
    file.add_run(run, {}, trajectory);
    file.commit();
    const ResultTable runs = read_results(path);
    ReportOptions options;
    options.rows = {BinSpec{}};
    options.columns = {"success"};
    options.simulation.resolution = 0.5;
    const ReportInput input = make_report_input(runs, options);
    const ScenarioRuns content = read_scenario_runs({&file}, runs, 0, 0);
    const World world(content.content, options.simulation.resolution);
    return argument(scenario_script(input, content, world, (folder_ / "report").string()),
                    "slalomScenario");
  }

  static Scenario room() {
    return Scenario::continuous("room", {0, 0, 30, 10}, {{{{5, 5}, 0.5}}, {}}, {1, 1, 0}, {9, 9});
  }

  /// The argument of the function call in a script.
  static nlohmann::json argument(const std::string& script, const std::string& function) {
    EXPECT_EQ(script.rfind(function + "(", 0), 0u) << script.substr(0, 40);
    const std::size_t from = function.size() + 1;
    return nlohmann::json::parse(script.substr(from, script.rfind(')') - from));
  }

  static std::vector<std::int64_t> sums(const nlohmann::json& differences) {
    std::vector<std::int64_t> numbers;
    std::int64_t sum = 0;
    for (const std::int64_t difference : differences) numbers.push_back(sum += difference);
    return numbers;
  }

  const QuantityInfo kLength = {"path_length", 1, "Path length", "m", Direction::Down};
  fs::path folder_;
};

TEST_F(ScenarioData, StoresTrajectoriesInThousandths) {
  const auto data = data_of(room(), 3);
  const auto& run = data["runs"][0];
  EXPECT_EQ(sums(run["t"]), (std::vector<std::int64_t>{0, 200}));
  EXPECT_EQ(sums(run["x"]), (std::vector<std::int64_t>{1000, 1200}));
  EXPECT_EQ(sums(run["y"]), (std::vector<std::int64_t>{1000, 1000}));
  // The border is nearest: 1 m below the center, minus the robot radius of 0.25 m.
  EXPECT_EQ(sums(run["c"]).front(), 750);
  EXPECT_EQ(data["discs"][0], (nlohmann::json{5.0, 5.0, 0.5}));
  EXPECT_EQ(data["reasons"][run["values"][0][0].get<int>()], "</script> stopped");
  EXPECT_EQ(run["seed"], "18446744073709551615");
}

TEST_F(ScenarioData, KeepsTheSamplesThatInterpolationNeedsForACentimeter) {
  const Scenario scenario = room();
  const World world(scenario, 0.5);
  const Footprint footprint = ReportOptions().robot.shape();
  Trajectory circles;  // two, of 3 m about the disc's left side, at 1 m/s
  std::vector<double> clearances;
  for (int i = 0; i <= 750; ++i) {
    const double t = 0.05 * i, turned = t / 3;
    circles.samples.push_back(
        {t,
         {4.5 + 3 * std::sin(turned), 5 - 3 * std::cos(turned), mrpt::math::wrapToPi(turned)},
         1,
         1.0 / 3});
    clearances.push_back(footprint_clearance(world, footprint, circles.samples.back().pose));
  }
  const auto run = data_of(scenario, circles)["runs"][0];
  const auto t = sums(run["t"]), x = sums(run["x"]), y = sums(run["y"]), h = sums(run["h"]),
             c = sums(run["c"]);
  EXPECT_LT(t.size(), 150U) << "of 751";
  std::size_t k = 1;
  for (std::size_t i = 0; i < circles.samples.size(); ++i) {
    const Sample& sample = circles.samples[i];
    while (k + 1 < t.size() && 0.001 * static_cast<double>(t[k]) < sample.t) ++k;
    const double fraction =
        (1000 * sample.t - static_cast<double>(t[k - 1])) / static_cast<double>(t[k] - t[k - 1]);
    const auto at = [&](const std::vector<std::int64_t>& values) {
      return 0.001 * (static_cast<double>(values[k - 1]) +
                      fraction * static_cast<double>(values[k] - values[k - 1]));
    };
    EXPECT_LE(std::hypot(at(x) - sample.pose.x, at(y) - sample.pose.y), 0.01) << i;
    EXPECT_NEAR(at(c), clearances[i], 0.01) << i;
    EXPECT_NEAR(at(h), sample.t / 3, 0.021) << "without a jump at half a turn: " << i;
  }
  EXPECT_EQ(t.front(), 0);
  EXPECT_EQ(t.back(), 37500);
  EXPECT_EQ(*std::min_element(c.begin(), c.end()),
            std::llround(1000 * *std::min_element(clearances.begin(), clearances.end())));
}

TEST_F(ScenarioData, StoresPeopleAsTheyWalkedInTheRun) {
  const Scenario scenario = room().with_people(
      {{"in the way", 0.3, 1, {6, 1}, {{0.5, 1}}}, {"later", 0.3, 1, {20, 5}, {{25, 5}}, 70}});
  const auto run = data_of(scenario, 21)["runs"][0];
  const ReportOptions options;
  Trajectory trajectory;
  for (int i = 0; i < 21; ++i) trajectory.samples.push_back({0.1 * i, {1 + 0.1 * i, 1, 0}});
  const Movers record = movers_along(World(scenario, 0.5), options.robot, options.simulation,
                                     trajectory, options.people);
  ASSERT_EQ(run["people"].size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& person = run["people"][i];
    EXPECT_EQ(person["id"], record[i].id);
    EXPECT_EQ(person["radius"], 0.3);
    std::vector<std::int64_t> t, x, y;
    for (const Waypoint& waypoint : record[i].waypoints) {
      t.push_back(std::llround(1000 * waypoint.t));
      x.push_back(std::llround(1000 * waypoint.position.x));
      y.push_back(std::llround(1000 * waypoint.position.y));
    }
    EXPECT_EQ(sums(person["t"]), t);
    EXPECT_EQ(sums(person["x"]), x);
    EXPECT_EQ(sums(person["y"]), y);
  }
  // It has walked towards the robot; the other one begins after the longest run.
  EXPECT_EQ(sums(run["people"][0]["x"]).front(), 6000);
  EXPECT_LT(sums(run["people"][0]["x"]).back(), 5000);
  EXPECT_EQ(run["people"][1]["t"], nlohmann::json{61000});
  EXPECT_FALSE(data_of(scenario, 0)["runs"][0].contains("people"));
  EXPECT_FALSE(data_of(room(), 21)["runs"][0].contains("people"));
}

TEST_F(ScenarioData, StoresGridsAsRunLengths) {
  // Two rows of three cells of 1 m: ". # #" below, "# . ." above.
  mrpt::maps::COccupancyGridMap2D map(0, 3, 0, 2, 1);
  for (int x = 0; x < 3; ++x) {
    map.setCell(x, 0, x == 0 ? 1.0f : 0.0f);
    map.setCell(x, 1, x == 0 ? 0.0f : 1.0f);
  }
  const auto data = data_of(Scenario::grid("grid", map, {0.5, 0.5, 0}, {2.5, 1.5}), 1);
  EXPECT_EQ(data["grid"]["runs"], (nlohmann::json{1, 3, 2}));
  EXPECT_EQ(data["grid"]["nx"], 3);
}

TEST_F(ScenarioData, LinksExistingRawlogsOnly) {
  const Scenario scenario = room();
  EXPECT_EQ(data_of(scenario, 2)["runs"][0]["rawlog"], "");
  const fs::path rawlog =
      rawlog_path((folder_ / "runs.results").string(), scenario.hash(), "nd & co", 0);
  fs::create_directories(rawlog.parent_path());
  std::ofstream(rawlog) << "a rawlog";
  const std::string link = data_of(scenario, 2)["runs"][0]["rawlog"];
  EXPECT_EQ(link.rfind("../", 0), 0u) << link;
  EXPECT_EQ(link.find_first_of(" &"), std::string::npos) << link;
}

}  // namespace
}  // namespace slalom
