// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "navigator_fixture.h"

#include <slalom/core/read_file.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

namespace fs = std::filesystem;

testing::AssertionResult refuses_navigator(const std::string& keys, const std::string& where,
                                           std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::Usage, "campaign.ini" + where, words,
                      [&] { load_navigator(keys); });
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  return names;
}

TEST(NavigatorMethod, StockConfigurationReachesTheGoalInAnEmptyRoom) {
  const auto method = load_navigator_with(stock_config());
  const SimulationResult result = run_navigator(*method, navigator_room());
  EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
  // 7.8 m to the edge of the goal at up to 1 m/s.
  EXPECT_GT(result.trajectory.duration(), 7.8);
  EXPECT_LT(result.trajectory.duration(), 25);
}

TEST(NavigatorMethod, StockConfigurationPassesDiscs) {
  const auto method = load_navigator_with(stock_config());
  const SimulationResult result = run_navigator(*method, navigator_room_with_discs());
  EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
  // A robot of radius 0.25 m cannot pass the disc of radius 0.5 m at (4, 5.2) on the straight line:
  // its path must deviate by at least 0.55 m.
  double lowest = 5;
  for (const Sample& sample : result.trajectory.samples) lowest = std::min(lowest, sample.pose.y);
  double highest = 5;
  for (const Sample& sample : result.trajectory.samples) highest = std::max(highest, sample.pose.y);
  EXPECT_TRUE(lowest < 5.2 - 0.75 || highest > 5.2 + 0.75) << lowest << ' ' << highest;
}

TEST(NavigatorMethod, ThreeDimensionalNavigatorPassesDiscs) {
  const auto method = load_navigator_with(test_config("small_navigator.ini"),
                                          "class = mrpt::nav::CReactiveNavigationSystem3D\n");
  const SimulationResult result = run_navigator(*method, navigator_room_with_discs());
  EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
}

TEST(NavigatorMethod, HolonomicRobotMovesSidewaysToTheGoal) {
  RobotModel robot;
  robot.kinematics = Kinematics::Holonomic;
  const auto method =
      load_navigator("config = " + test_config("holonomic_navigator.ini") + "\n", robot);
  const World room(Scenario::continuous("room", {0, 0, 10, 10}, {}, {1, 5, 0}, {5, 8}), 0.05);
  const SimulationResult result = run_navigator(*method, room, 60, robot);
  EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
  double max_lateral = 0;
  for (const Sample& sample : result.trajectory.samples)
    max_lateral = std::max(max_lateral, sample.command_vy);
  EXPECT_GT(max_lateral, 0.1);
}

TEST(NavigatorMethod, HolonomicCommandsForADifferentialDriveEndTheRunAsAnError) {
  const auto method = load_navigator_with(test_config("holonomic_navigator.ini"));
  const SimulationResult result = run_navigator(*method, navigator_room());
  EXPECT_EQ(result.outcome, Outcome::MethodError);
  EXPECT_TRUE(
      mentions(result.detail, {"command", "mrpt::kinematics::CVehicleVelCmd_Holo", "diff_drive"}));
}

TEST(NavigatorMethod, ExceptionsCaughtByTheNavigatorEndTheRunWithTheirReason) {
  const std::string path = testing::TempDir() + "wrong_formula.ini";
  {
    std::ifstream in(test_config("small_navigator.ini"));
    std::ofstream out(path);
    for (std::string line; std::getline(in, line);)
      out << (line.rfind("scalar_score_formula", 0) == 0 ? "scalar_score_formula = no_such" : line)
          << '\n';
  }
  const auto method = load_navigator_with(path);
  for (int run = 0; run < 2; ++run) {
    const SimulationResult result = run_navigator(*method, navigator_room());
    EXPECT_EQ(result.outcome, Outcome::MethodError);
    EXPECT_NE(result.detail.find("Undefined symbol: 'no_such'"), std::string::npos)
        << result.detail;
    EXPECT_EQ(result.detail.find('\n'), std::string::npos) << result.detail;
  }
}

TEST(NavigatorMethod, WritesNothingToTheTerminalAndLeavesNoFiles) {
  const auto here = names_in(fs::current_path());
  // A separate folder for temporary files, because other programs use the common one.
  std::string temporary = testing::TempDir() + "slalom_navigator_XXXXXX";
  ASSERT_NE(mkdtemp(temporary.data()), nullptr);
  setenv("TMPDIR", temporary.c_str(), 1);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  {
    const auto method = load_navigator_with(test_config("small_navigator.ini"));
    run_navigator(*method, navigator_room_with_discs());
    run_navigator(*method, navigator_room_with_discs());
    // The goal is inside a disc: the navigator logs errors and gives up.
    Primitives blocked;
    blocked.discs = {{{9, 5}, 0.6}};
    run_navigator(*method, navigator_room(blocked));
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(names_in(fs::current_path()), here);
  EXPECT_EQ(names_in(temporary), std::vector<std::string>());
  unsetenv("TMPDIR");
  fs::remove_all(temporary);
}

TEST(NavigatorMethod, GivingUpABlockedTargetIsNotAMethodError) {
  Primitives blocked;
  blocked.discs = {{{9, 5}, 0.6}};
  const auto method = load_navigator_with(test_config("small_navigator.ini"));
  const SimulationResult result = run_navigator(*method, navigator_room(blocked));
  EXPECT_EQ(result.outcome, Outcome::Stuck) << result.detail;
}

TEST(NavigatorMethod, CollisionGridsAreKeptInTheConfiguredFolder) {
  const std::string folder = testing::TempDir() + "slalom_ptg_cache";
  fs::remove_all(folder);
  const std::string config = test_config("small_navigator.ini");
  const auto first = load_navigator_with(config, "ptg_cache = " + folder + "\n");
  ASSERT_EQ(names_in(folder).size(), 1U);
  const auto grids = fs::path(folder) / names_in(folder)[0] / "ReacNavGrid_000.dat.gz";
  const auto written = fs::last_write_time(grids);
  const auto second = load_navigator_with(config, "ptg_cache = " + folder + "\n");
  EXPECT_EQ(fs::last_write_time(grids), written);
  EXPECT_EQ(hashes_of_runs(*first, 3, 5), hashes_of_runs(*second, 3, 5));
  // Another .ini content uses other grids.
  load_navigator_with(config, "margin = 0.1\nptg_cache = " + folder + "\n");
  EXPECT_EQ(names_in(folder).size(), 2U);
}

TEST(NavigatorMethod, TheObstacleFilterCanBeSwitchedOff) {
  const std::string config = test_config("small_navigator.ini");
  const auto as_in_file = hashes_of_runs(*load_navigator_with(config), 5, 8);
  EXPECT_EQ(hashes_of_runs(*load_navigator_with(config, "obstacle_filter = on\n"), 5, 8),
            as_in_file);
  EXPECT_NE(hashes_of_runs(*load_navigator_with(config, "obstacle_filter = off\n"), 5, 8),
            as_in_file);
}

TEST(NavigatorMethod, RefusesMissingFilesAndClassesInOneLine) {
  const std::string small = "config = " + test_config("small_navigator.ini") + "\n";
  EXPECT_TRUE(
      refuses_navigator("", ": [method.nav] config: ", {"configuration", "expected an MRPT .ini"}));
  EXPECT_TRUE(refuses_navigator("config = /nowhere/nav.ini\n", ":3: [method.nav] config: ",
                                {"config '/nowhere/nav.ini' not found", "expected a file"}));
  EXPECT_TRUE(
      refuses_navigator(small + "class = CReactive\n", ":4: [method.nav] class: ",
                        {"navigator class 'CReactive'", "expected CReactiveNavigationSystem",
                         "CReactiveNavigationSystem3D", "plugin"}));
  EXPECT_TRUE(refuses_navigator("plugin = /nowhere/libnav.so\n", ":3: [method.nav] plugin: ",
                                {"library '/nowhere/libnav.so' not found", "expected a file"}));
  EXPECT_TRUE(refuses_navigator(small + "modules = /nowhere/libptg.so\n",
                                ":4: [method.nav] modules: ", {"cannot be loaded (/nowhere/"}));
  EXPECT_TRUE(refuses_navigator(small + "marign = 1\n", "", {"'margin'"}));
}

TEST(NavigatorMethod, IsMadeFromOptionsOfAProgram) {
  NavigatorOptions options;
  options.config = stock_config();
  EXPECT_NE(mrpt_navigator(options)({}, {}), nullptr);
  EXPECT_TRUE(throws_error(ErrorKind::Usage,
                           "mrpt_navigator.config: ", {"missing configuration", "MRPT .ini"},
                           [] { mrpt_navigator({})({}, {}); }));
}

TEST(NavigatorMethod, RefusesAConfigurationWithoutANavigator) {
  const std::string path = testing::TempDir() + "not_a_navigator.ini";
  std::ofstream(path) << "[CHolonomicND]\nfactorWeights = 1 2 3 4\n";
  const std::string text =
      error_text(ErrorKind::Usage, [&] { load_navigator("config = " + path + "\n"); });
  EXPECT_EQ(text.rfind("campaign.ini:3: [method.nav] config: ", 0), 0U) << text;
  EXPECT_TRUE(mentions(text, {"the navigator rejects it ("}));
  EXPECT_EQ(text.find("0x"), std::string::npos) << text;
}

TEST(NavigatorMethod, ARefusedConfigurationIsNamedBySectionKeyAndNumbers) {
  std::string config = read_file(test_config("small_navigator.ini"));
  const std::string selected = "holonomic_method = CHolonomicND\n";
  const std::size_t at = config.find(selected);
  ASSERT_NE(at, std::string::npos);
  config.replace(at, selected.size(), "holonomic_method = CHolonomicFullEval\n");
  const std::string path = testing::TempDir() + "too_few_weights.ini";
  std::ofstream(path) << config << "\n[CHolonomicFullEval]\nfactorWeights = 1 2 3 4\n";
  EXPECT_TRUE(refuses_navigator(
      "config = " + path + "\n", ":3: [method.nav] config: ",
      {"the navigator rejects it (at [CHolonomicFullEval] factorWeights: ASSERT_EQUAL_(",
       "factorWeights.size()=4 ", "FACTORS="}));
}

}  // namespace
}  // namespace slalom
