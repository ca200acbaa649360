#include "error_text.h"
#include "navigator_drive.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

std::string plugin_keys(const std::string& class_name) {
  return "plugin = " + std::string(SLALOM_OWN_NAVIGATORS) + "\nclass = " + class_name + "\n";
}

std::string refusal(const std::string& keys, const RobotModel& robot = {}) {
  return error_text(Culprit::Usage, [&] { load_navigator(keys, robot); });
}

TEST(NavigatorPlugin, DrivesTheRobot) {
  const auto method = load_navigator("plugin = " + std::string(SLALOM_OWN_NAVIGATORS) + "\n");
  const SimulationResult result = drive_navigator(*method, navigator_room());
  EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
}

// Its navigators are slower in each further navigation: 1, 1/2, 1/3 m/s.
TEST(NavigatorPlugin, NoNavigatorShowsThatItHasDrivenBefore) {
  for (const std::string name : {"Ahead", "Forgetting", "Unforgetting"}) {
    const auto method = load_navigator(plugin_keys(name));
    for (int run = 0; run < 3; ++run) {
      const SimulationResult result = drive_navigator(*method, navigator_room(), 1);
      EXPECT_EQ(result.trajectory.samples.at(3).command_v, 1) << name << ' ' << run;
    }
  }
}

TEST(NavigatorPlugin, WhatItThrowsEndsTheRunInOneLine) {
  const auto method = load_navigator(plugin_keys("Throwing"));
  const SimulationResult result = drive_navigator(*method, navigator_room());
  EXPECT_EQ(result.outcome, Outcome::MethodError);
  EXPECT_EQ(result.detail.rfind("out of ideas", 0), 0U) << result.detail;
}

TEST(NavigatorPlugin, IsToldTheRobot) {
  RobotModel wide;
  wide.radius = 0.5;
  EXPECT_NE(load_navigator(plugin_keys("Narrow")), nullptr);
  EXPECT_NE(refusal(plugin_keys("Narrow"), wide).find("(too wide a robot)"), std::string::npos);
}

TEST(NavigatorPlugin, RefusesWhatIsNotThereInOneLine) {
  EXPECT_EQ(
      refusal(plugin_keys("Other")),
      "campaign.ini:4: [method.nav] class: the plug-in has no navigator 'Other'; expected one "
      "that it knows");
  const std::string library = SLALOM_STRAIGHT_HOLONOMIC;
  EXPECT_EQ(refusal("plugin = " + library + "\n"),
            "campaign.ini:3: [method.nav] plugin: '" + library +
                "' exports no slalom_make_navigator_v1(); expected a function marked with "
                "SLALOM_NAVIGATOR_EXPORT");
  EXPECT_NE(refusal(plugin_keys("Ahead") + "record_navlog = " + testing::TempDir() + "no_log\n")
                .find("this navigator keeps no such log"),
            std::string::npos);
}

// MRPT's navigators take holonomic methods, trajectory generators and more from such modules.
TEST(NavigatorPlugin, ModulesOfMrptAreLoadedFirst) {
  EXPECT_NE(load_navigator_with(test_config("small_navigator.ini"),
                                "modules = " + std::string(SLALOM_STRAIGHT_HOLONOMIC) + "\n"),
            nullptr);
}

}  // namespace
}  // namespace slalom
