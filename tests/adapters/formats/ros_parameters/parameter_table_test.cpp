// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"

#include <slalom/core/enum_names.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/robot/robot_model.h>
#include <slalom/ros_parameters/parameter_table.h>
#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace slalom {
namespace {

template <typename Options>
std::vector<std::string> keys_of() {
  std::vector<std::string> keys;
  Options options;
  OptionFunction add([&](const Option& option) { keys.push_back(option.key); });
  options.visit(add);
  return keys;
}

/// The keys of [robot], of [sensor], of [simulation], or of a shipped method: its .ini has all.
std::vector<std::string> keys_of(const std::string& section) {
  if (section == "robot") return keys_of<RobotModel>();
  if (section == "sensor") return keys_of<SensorModel>();
  if (section == "simulation") return keys_of<SimulationOptions>();
  return IniFile::load(kReactiveAlgos + "/" + section + "/" + section + ".ini")
      .keys("method." + section);
}

TEST(RosParameterTable, EveryTargetIsAKeyOfItsSection) {
  for (const RosMapping& row : ros_parameter_table()) {
    const std::string section = row.section, target = row.target;
    EXPECT_EQ(section.empty(), target.empty()) << row.key;
    EXPECT_EQ(section.empty(), row.convert == nullptr) << row.key;
    if (!section.empty())
      EXPECT_TRUE(contains(keys_of(section), target)) << row.key << " is " << target;
    else
      EXPECT_STRNE(row.note, "") << row.key << " has no counterpart for no reason";
  }
}

/// Whether each method of a family has a row of the key.
bool reaches_methods(RosFamily family, const std::string& key) {
  std::vector<std::string> sections;
  for (const RosMapping* row : find_mappings(family, key)) sections.emplace_back(row->section);
  if (!method_of(family).empty()) return contains(sections, method_of(family));
  for (const RosFamily controller : enum_values<RosFamily>()) {
    const std::string method = method_of(controller);
    if (!method.empty() && !contains(sections, method)) return false;
  }
  return true;
}

TEST(RosParameterTable, AKeyWithoutCounterpartInAMethodHasAReason) {
  for (const RosMapping& row : ros_parameter_table()) {
    if (row.family == RosFamily::VelocitySmoother) continue;  // for robots only
    const auto rows = find_mappings(row.family, row.key);
    const bool has_reason = std::any_of(
        rows.begin(), rows.end(), [](const RosMapping* other) { return *other->section == '\0'; });
    EXPECT_TRUE(has_reason || reaches_methods(row.family, row.key))
        << to_string(row.family) << " " << row.key;
  }
}

TEST(RosParameterTable, NoRowIsThereTwice) {
  std::vector<std::string> rows;
  for (const RosMapping& row : ros_parameter_table()) {
    const std::string text =
        to_string(row.family) + " " + row.key + " " + row.section + " " + row.target;
    EXPECT_FALSE(contains(rows, text)) << text;
    rows.push_back(text);
  }
}

TEST(RosParameterTable, IsThatOfTheDocument) {
  const std::string document =
      read_text(kDocs + "/methods/nav2_parameters.md", "a document", kMaxConfigSize);
  for (const RosFamily family : enum_values<RosFamily>()) {
    const std::string section = "\n### " + to_string(family) + "\n\n" + markdown_table(family);
    EXPECT_NE(document.find(section), std::string::npos)
        << "docs/methods/nav2_parameters.md has not\n"
        << section;
  }
}

TEST(RosParameterTable, AStarStandsForAnySections) {
  const auto family = RosFamily::LocalCostmap;
  for (const char* key :
       {"inflation_radius", "inflation_layer.inflation_radius", "a.b.inflation_radius"})
    EXPECT_EQ(find_mappings(family, key).size(), 5U) << key;  // four methods, and why not the fifth
  EXPECT_TRUE(find_mappings(family, "inflation_radius.a").empty());
  EXPECT_TRUE(find_mappings(family, "no_inflation_radius").empty());
}

}  // namespace
}  // namespace slalom
