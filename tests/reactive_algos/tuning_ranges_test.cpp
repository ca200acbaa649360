// SPDX-License-Identifier: BSD-3-Clause
// The ranges of options that the shipped methods declare for tuning.
#include "places.h"

#include <slalom/core/random.h>
#include <slalom/core/text.h>
#include <slalom/library/library_method.h>
#include <slalom/methods/registry.h>
#include <slalom/mrpt_nav/holonomic_method.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// A section [method.*] of the baselines with a shipped plug-in or a holonomic class of MRPT.
struct Baseline {
  IniFile ini;
  std::string section;
  MethodReader read;

  /// Creates the method with these values and begins a run, in which plug-ins of MRPT read them.
  std::unique_ptr<Method> create(const std::map<std::string, double>& values = {}) const {
    IniFile changed = ini;
    for (const auto& [name, value] : values) changed.set(section, name, format_number(value));
    auto method = read(changed, section)({}, {});
    NavigationTask task;
    task.goal = {5, 0};
    task.control_period = 0.1;
    method->reset(task);
    return method;
  }
};

std::vector<Baseline> baselines() {
  IniFile ini = IniFile::load(kConfigs + "/baselines.ini");
  std::vector<Baseline> result;
  for (const std::string& section : ini.sections()) {
    const std::string adapter = ini.get(section, "adapter").value_or("");
    if (adapter != "library" && adapter != "mrpt_holonomic") continue;
    if (const auto plugin = ini.get(section, "plugin"))
      ini.set(section, "plugin", kMethods + "/" + *plugin);
    result.push_back(
        {ini, section, adapter == "library" ? read_library_method : read_holonomic_method});
  }
  return result;
}

double random_value(const TunableParameter& p, RandomEngine& random) {
  if (p.integer) return uniform_int(random, static_cast<int>(p.low), static_cast<int>(p.high));
  if (!p.log) return uniform_real(random, p.low, p.high);
  return std::exp(uniform_real(random, std::log(p.low), std::log(p.high)));
}

TEST(TuningRanges, AreThoseOfEveryShippedPlugin) {
  std::set<std::string> built, tested;
  for (const auto& file : fs::directory_iterator(kMethods))
    if (file.is_regular_file()) built.insert(file.path().string());
  for (const Baseline& baseline : baselines())
    if (const auto plugin = baseline.ini.get(baseline.section, "plugin")) tested.insert(*plugin);
  EXPECT_EQ(tested, built);
}

TEST(TuningRanges, ContainTheDefaults) {
  for (const Baseline& baseline : baselines()) {
    const auto parameters = baseline.create()->tunable_parameters();
    EXPECT_FALSE(parameters.empty()) << baseline.section;
    std::set<std::string> names;
    for (const TunableParameter& p : parameters) {
      const std::string where = baseline.section + " " + p.name;
      EXPECT_TRUE(names.insert(p.name).second) << where << " is declared twice";
      EXPECT_LT(p.low, p.high) << where;
      EXPECT_LE(p.low, p.default_value) << where;
      EXPECT_GE(p.high, p.default_value) << where;
      EXPECT_TRUE(!p.log || p.low > 0) << where;
      for (const double value : {p.low, p.default_value, p.high})
        EXPECT_TRUE(!p.integer || value == std::round(value)) << where;
    }
  }
}

TEST(TuningRanges, HaveNoValueThatTheMethodRefuses) {
  for (const Baseline& baseline : baselines()) {
    const auto parameters = baseline.create()->tunable_parameters();
    std::map<std::string, double> lowest, highest;
    for (const TunableParameter& p : parameters) {
      lowest[p.name] = p.low;
      highest[p.name] = p.high;
      for (const double value : {p.low, p.default_value, p.high})
        EXPECT_NO_THROW(baseline.create({{p.name, value}})) << baseline.section << " " << p.name;
    }
    EXPECT_NO_THROW(baseline.create(lowest)) << baseline.section;
    EXPECT_NO_THROW(baseline.create(highest)) << baseline.section;
  }
}

TEST(TuningRanges, HaveNoCombinationThatTheMethodRefuses) {
  RandomEngine random(1);
  for (const Baseline& baseline : baselines()) {
    const auto parameters = baseline.create()->tunable_parameters();
    for (int k = 0; k < 20; ++k) {
      std::map<std::string, double> values;
      for (const TunableParameter& p : parameters) values[p.name] = random_value(p, random);
      EXPECT_NO_THROW(baseline.create(values)) << baseline.section << ", configuration " << k;
    }
  }
}

}  // namespace
}  // namespace slalom
