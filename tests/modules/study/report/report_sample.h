// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "memory_folder.h"

#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/report/report.h>
#include <slalom/results/privileged.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace slalom {

/// Result files of two methods, "good" and "<bad>", and their reports.
class ReportTest : public testing::Test {
 protected:
  ReportTest() {
    std::string pattern = (memory_folder() / "slalom_report_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~ReportTest() override { std::filesystem::remove_all(folder_); }

  /// Scenarios with one disc each, run by both methods; the second one always collides.
  ResultFile make_results(int scenarios, const std::string& name = "room",
                          const std::string& privileged = "") const {
    Manifest manifest = {{"campaign", "<campaign> & co"},
                         {"campaign.ini", "[analysis]\nrows = density:0,0.5,1\n"}};
    if (!privileged.empty()) manifest[kPrivilegedKey] = privileged;
    const QuantityInfo density = {"density", 1, "Density", "-", Direction::None};
    const QuantityInfo success = success_info();
    const QuantityInfo optimality = {"optimality", 1, "Optimality", "-", Direction::Up};
    ResultFile file =
        ResultFile::create(results_path(), manifest, {density}, {success, optimality});
    for (int i = 0; i < scenarios; ++i) add_scenario(file, i, name + " " + std::to_string(i));
    file.commit();
    return file;
  }

  std::string results_path() const { return (folder_ / "runs.results").string(); }
  std::filesystem::path report_folder() const { return folder_ / "report"; }
  ReportOptions options() const { return report_options(read_results(results_path())); }

  void write(const ResultFile& file, const ReportOptions& options) const {
    write_report(file.path(), read_results(file.path()), options, report_folder().string());
  }
  void write(const ResultFile& file) const { write(file, options()); }

  std::string read(const std::string& name) const {
    std::ifstream stream(report_folder() / name, std::ios::binary);
    EXPECT_TRUE(stream) << name;
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// The options with a cluster of failures of "<bad>" in room 0 and room 1 (runs 0 and 2): the
  /// second is compared with the runs of "good" in rooms 0 and 1.
  ReportOptions options_with_cluster() const {
    ReportOptions made = options();
    ReportedCluster cluster;
    cluster.name = "collision, <sharp>";
    cluster.basis = "7 of 2 failures compared";
    const MatchedValues depth = {{"depth", 1, "Depth & co", "m", Direction::None},
                                 {3, 4, 5, 6, 7, 8, 9},
                                 {1, 1, 1, 1, 1, 1, 1}};
    MatchedValues width = depth;
    width.quantity = {"width", 1, "Width", "m", Direction::None};
    width.reference = {1, 8, 1, 8, 9, 8, 9};
    cluster.scenarios = contrast_matched({width, depth}, 0.95);
    cluster.statements = {contrast_sentence(cluster.scenarios[0], "neighbors")};
    cluster.members = {{0, "candidate 1", "slalom-replay play <here>", "bad <leaves>", 0, {}},
                       {2, "candidate 2", "slalom-replay play there", "", 2, {1, 3}}};
    made.clusters = {cluster};
    return made;
  }

  nlohmann::json report_json() const { return nlohmann::json::parse(read("report.json")); }

  std::filesystem::path folder_;
  People people_;     ///< in each scenario
  double side_ = 10;  ///< of each scenario (m)
  double turn_ = 0;   ///< rad/s, of "<bad>", which then stands until it is stuck

 private:
  void add_scenario(ResultFile& file, int i, const std::string& name) const {
    const Primitives obstacles = {{{{5, 5}, 0.5 + 0.001 * i}}, {}};
    const Scenario scenario =
        Scenario::continuous(name, {0, 0, side_, side_}, obstacles, {1, 1, 0}, {9, 9})
            .with_people(people_);
    ScenarioRecord record{scenario.hash(), scenario.name(), {}};
    record.descriptors["density"] = {1, Value::of(0.001 * i)};
    References references;
    references.shortest = ShortestPath{{{1, 1}, {6, 4}, {9, 9}}, 12.0, {11.9, 12.0}, "exact", ""};
    references.safest_reason = "not requested";
    file.add_scenario(record, scenario, references);
    for (const bool reached : {true, false})
      file.add_run(make_run(scenario, reached), {}, make_trajectory(reached));
  }

  Trajectory make_trajectory(bool reached) const {
    Trajectory trajectory;
    for (int i = 0; i <= (reached ? 80 : 30); ++i) {
      Sample sample;
      sample.t = 0.1 * i;
      sample.pose = {1 + 0.1 * i, 1 + 0.1 * i, 0.785};
      if (!reached && turn_ > 0) sample.pose = {1, 1, turn_ * sample.t};
      trajectory.samples.push_back(sample);
    }
    return trajectory;
  }

  RunRecord make_run(const Scenario& scenario, bool reached) const {
    RunRecord run;
    run.scenario_hash = scenario.hash();
    run.scenario_name = scenario.name();
    run.method = reached ? "good" : "<bad>";
    run.outcome = reached ? "success" : turn_ > 0 ? "stuck" : "collision";
    run.outcome_detail = reached ? "" : "with a \"disc\"";
    run.metrics["success"] = {1, Value::of(reached ? 1 : 0)};
    run.metrics["optimality"] = {1, reached ? Value::of(0.9) : Value::na("collision")};
    return run;
  }
};

}  // namespace slalom
