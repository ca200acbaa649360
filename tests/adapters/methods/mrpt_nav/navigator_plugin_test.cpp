// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "navigator_fixture.h"
#include "places.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

const std::string kOwnNavigators = kBuild + "/lib/libown_navigators.so";
const std::string kStraightHolonomic = kBuild + "/lib/libstraight_holonomic.so";

std::string plugin_keys(const std::string& class_name) {
  return "plugin = " + kOwnNavigators + "\nclass = " + class_name + "\n";
}

testing::AssertionResult refuses_plugin(const std::string& keys, const std::string& where,
                                        std::initializer_list<std::string> words,
                                        const RobotModel& robot = {}) {
  return throws_error(ErrorKind::Usage, "campaign.ini" + where, words,
                      [&] { load_navigator(keys, robot); });
}

TEST(NavigatorPlugin, ReachesTheGoal) {
  const auto method = load_navigator("plugin = " + kOwnNavigators + "\n");
  const SimulationResult result = run_navigator(*method, navigator_room());
  EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
}

// These navigators get slower with each navigation, 1, 1/2, 1/3 m/s, unless they are reset.
TEST(NavigatorPlugin, NavigatorsAreResetOrCreatedAgainForEachRun) {
  for (const std::string name : {"Ahead", "Resetting", "NotResetting"}) {
    const auto method = load_navigator(plugin_keys(name));
    for (int run = 0; run < 3; ++run) {
      const SimulationResult result = run_navigator(*method, navigator_room(), 1);
      EXPECT_EQ(result.trajectory.samples.at(3).command_v, 1) << name << ' ' << run;
    }
  }
}

TEST(NavigatorPlugin, AnExceptionEndsTheRunWithAnErrorInOneLine) {
  const auto method = load_navigator(plugin_keys("Throwing"));
  const SimulationResult result = run_navigator(*method, navigator_room());
  EXPECT_EQ(result.outcome, Outcome::MethodError);
  EXPECT_EQ(result.detail.rfind("out of ideas", 0), 0U) << result.detail;
}

TEST(NavigatorPlugin, ReceivesTheRobot) {
  RobotModel wide;
  wide.radius = 0.5;
  EXPECT_NE(load_navigator(plugin_keys("Narrow")), nullptr);
  EXPECT_TRUE(refuses_plugin(plugin_keys("Narrow"), "", {"robot too wide"}, wide));
}

TEST(NavigatorPlugin, RefusesUnknownClassesAndMissingFunctions) {
  EXPECT_TRUE(
      refuses_plugin(plugin_keys("Other"), ":4: [method.nav] class: ", {"plug-in", "'Other'"}));
  EXPECT_TRUE(
      refuses_plugin("plugin = " + kStraightHolonomic + "\n", ":3: [method.nav] plugin: ",
                     {"'" + kStraightHolonomic + "' does not export slalom_make_navigator_v1()",
                      "SLALOM_NAVIGATOR_EXPORT"}));
  EXPECT_TRUE(
      refuses_plugin(plugin_keys("Ahead") + "record_navlog = " + testing::TempDir() + "no_log\n",
                     ":5: [method.nav] record_navlog: ", {"no such log", "trajectory generators"}));
}

// MRPT's navigators take holonomic methods, trajectory generators and more from such modules.
TEST(NavigatorPlugin, ModulesOfMrptAreLoadedFirst) {
  EXPECT_NE(load_navigator_with(test_config("small_navigator.ini"),
                                "modules = " + kStraightHolonomic + "\n"),
            nullptr);
}

}  // namespace
}  // namespace slalom
