// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/methods/registry.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace slalom {
namespace {

class StoppedMethod : public Method {
 public:
  void reset(const NavigationTask&) override {}
  Command step(const Observation&) override { return {}; }
};

MethodRegistry registry_of_two() {
  MethodRegistry registry;
  registry.add("still", [](const IniFile&, const std::string& section) {
    EXPECT_EQ(section, "method.a");
    return [](const RobotModel&, const SensorModel&) { return std::make_unique<StoppedMethod>(); };
  });
  registry.add("broken", [](const IniFile& ini, const std::string&) -> MethodFactory {
    throw usage_error(ini.name(), "no such class");
  });
  return registry;
}

::testing::AssertionResult refused(const std::string& ini_text, const std::string& where,
                                   std::initializer_list<std::string> words) {
  const IniFile ini = IniFile::from_text(ini_text, "campaign.ini");
  return throws_error(ErrorKind::Usage, where, words, [&] { registry_of_two().read(ini, "a"); });
}

struct PluginOptions {
  std::string plugin, folder;
  std::vector<std::pair<std::string, std::string>> parameters;
  void visit(OptionVisitor& v) { v.option("plugin", plugin, External::Library, "a library"); }
};

TEST(ReadParameterOptions, TakesKeysThatAreNotOfTheAdapterForParameters) {
  const IniFile ini = IniFile::from_text(
      "[method.a]\nadapter = x\ngain = 2\nplugin = y\nname = z\n", "folder/campaign.ini");
  const std::vector<std::pair<std::string, std::string>> expected = {{"gain", "2"}, {"name", "z"}};
  auto options = read_parameter_options<PluginOptions>(ini, "method.a");
  std::sort(options.parameters.begin(), options.parameters.end());
  EXPECT_EQ(options.parameters, expected);
  EXPECT_EQ(options.plugin, "y");
  EXPECT_EQ(options.folder, "folder");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "folder/campaign.ini:", {"unknown key"},
                           [&] { read_adapter_options<PluginOptions>(ini, "method.a"); }));
}

TEST(MethodRegistry, ReadsTheMethodOfTheSection) {
  const IniFile ini = IniFile::from_text("[method.a]\nadapter = still\n", "campaign.ini");
  const NamedMethod method = registry_of_two().read(ini, "a");
  EXPECT_EQ(method.name, "a");
  EXPECT_EQ(method.where, "campaign.ini:1: [method.a]");
  EXPECT_NE(method.make({}, {}), nullptr);
}

TEST(MethodRegistry, ReadsAFilterAroundAnotherMethod) {
  const IniFile ini = IniFile::from_text(
      "[method.safer]\nfilter = cbf\nbase = safe\n[method.safe]\nfilter = cbf\nbase = a\nmargin = "
      "0.1\n[method.a]\nadapter = still\n",
      "campaign.ini");
  const NamedMethod method = registry_of_two().read(ini, "safer");
  EXPECT_EQ(method.name, "safer");
  EXPECT_EQ(method.where, "campaign.ini:1: [method.safer]");
  EXPECT_NE(method.make({}, {}), nullptr);
  EXPECT_EQ(method_sections(ini, "safer"),
            (std::vector<std::string>{"method.safer", "method.safe", "method.a"}));
  EXPECT_EQ(method_sections(ini, "a"), std::vector<std::string>{"method.a"});
}

TEST(MethodRegistry, ReportsFiltersWithoutABase) {
  EXPECT_TRUE(refused("[method.a]\nfilter = cbf\n", "campaign.ini:2: [method.a] filter",
                      {"missing base", "base = NAME"}));
  EXPECT_TRUE(refused("[method.a]\nfilter = cbf\nbase = b\n", "campaign.ini:3: [method.a] base",
                      {"no section for method 'b'", "[method.b]"}));
  EXPECT_TRUE(refused("[method.a]\nfilter = cbf\nbase = b\n[method.b]\nfilter = cbf\nbase = a\n",
                      "campaign.ini:6: [method.b] base",
                      {"'a' is around itself", "another method, with an adapter"}));
}

TEST(MethodRegistry, ReportsInvalidKeysOfFilters) {
  const auto refused_key = [](const std::string& keys, const std::string& where,
                              std::initializer_list<std::string> words) {
    const IniFile ini = IniFile::from_text(
        "[method.a]\nadapter = still\n[method.safe]\nbase = a\n" + keys, "campaign.ini");
    return throws_error(ErrorKind::Usage, where, words,
                        [&] { registry_of_two().read(ini, "safe"); });
  };
  EXPECT_TRUE(refused_key("filter = cbf\nadapter = still\n",
                          "campaign.ini:6: [method.safe] adapter", {"unknown key", "gain"}));
  EXPECT_TRUE(
      refused_key("filter = brake\n", "campaign.ini:5: [method.safe] filter", {"'brake'", "cbf"}));
  EXPECT_TRUE(
      refused_key("filter = cbf\ngain = 0\n", "campaign.ini:6: [method.safe] gain", {"> 0"}));
}

TEST(MethodRegistry, ListsItsAdapters) {
  EXPECT_EQ(registry_of_two().adapters(), (std::vector<std::string>{"broken", "still"}));
}

TEST(MethodRegistry, ReportsMissingSectionsAndAdapters) {
  EXPECT_TRUE(refused("[robot]\nradius = 1\n", "campaign.ini: ", {"'a'", "expected [method.a]"}));
  EXPECT_TRUE(refused("[method.a]\nclass = X\n", "campaign.ini:1: ", {"broken | still"}));
  EXPECT_TRUE(refused("[method.a]\nadapter = lcm2\n",
                      "campaign.ini:2: ", {"'lcm2'", "expected one of broken, still"}));
}

TEST(MethodRegistry, PassesOnExceptionsOfTheAdapter) {
  EXPECT_TRUE(refused("[method.a]\nadapter = broken\n", "campaign.ini: ", {"no such class"}));
}

TEST(IsValidCommand, AcceptsTheLimitsWithRoundingErrors) {
  const RobotModel robot;
  std::string reason;
  EXPECT_TRUE(is_valid_command({robot.max_v, robot.max_w}, robot, reason));
  EXPECT_TRUE(is_valid_command({0, -robot.max_w}, robot, reason));
  EXPECT_TRUE(is_valid_command({-1e-10, robot.max_w + 1e-10}, robot, reason));
  EXPECT_EQ(reason, "");
}

TEST(IsValidCommand, NamesTheComponentOutsideTheLimits) {
  RobotModel robot;
  std::string reason;
  EXPECT_FALSE(is_valid_command({1.25, 0}, robot, reason));
  EXPECT_EQ(reason, "v = 1.25 is outside [0, 1]");
  EXPECT_FALSE(is_valid_command({-0.5, 0}, robot, reason));
  EXPECT_EQ(reason, "v = -0.5 is outside [0, 1]");
  EXPECT_FALSE(is_valid_command({0, -2}, robot, reason));
  EXPECT_EQ(reason, "w = -2 is outside [-1.5, 1.5]");
  robot.forward_only = false;
  EXPECT_TRUE(is_valid_command({-0.5, 0}, robot, reason));
}

TEST(IsValidCommand, AllowsLateralVelocityForHolonomicRobotsOnly) {
  RobotModel robot;
  std::string reason;
  EXPECT_FALSE(is_valid_command({0, 0, 0.1}, robot, reason));
  EXPECT_EQ(reason, "vy = 0.1 of a differential drive is not 0");
  robot.kinematics = Kinematics::Holonomic;
  EXPECT_TRUE(is_valid_command({0.6, 0, -0.8}, robot, reason));
  EXPECT_FALSE(is_valid_command({0.7, 0, 0.8}, robot, reason));
  EXPECT_NE(reason.find("speed = 1.063"), std::string::npos) << reason;
}

TEST(IsValidCommand, RefusesNonFiniteValues) {
  std::string reason;
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(is_valid_command({bad, 0}, {}, reason));
    EXPECT_FALSE(is_valid_command({0, bad}, {}, reason));
    EXPECT_NE(reason.find("not a finite number"), std::string::npos);
  }
}

}  // namespace
}  // namespace slalom
