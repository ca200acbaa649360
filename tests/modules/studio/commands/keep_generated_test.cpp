// SPDX-License-Identifier: BSD-3-Clause
#include "io_sample.h"
#include "keep_generated.h"

#include <slalom/campaign/scenario_sources.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(KeepGenerated, StoresScenariosWithOriginAndValues) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  const IniFile ini = IniFile::from_text("[scenarios]\ngenerator = random, maze\ncount = 4\n");
  DescribeOptions options;
  options.ids = {"density", "clearness"};
  SourceContext context;
  context.jobs = 3;
  context.describe = [&](const World& world) { return generated_values(world, options); };
  const auto progress = make_silent_progress();
  stream_scenarios(
      read_scenario_sources(ini, context, {}), {}, *progress,
      [&](std::vector<GeneratedScenario>& part) { return keep_generated(list, part); });
  const auto entries = list.entries();
  ASSERT_EQ(entries.size(), 4U);
  EXPECT_EQ(entries[0].generator, "random");
  EXPECT_EQ(entries[1].generator, "maze");
  for (const auto& entry : entries) {
    EXPECT_TRUE(entry.seed.has_value());
    // Stored values are found later and equal the computed ones.
    MemoryDescriptorStore empty;
    for (const KeyedValue& computed : describe_scenario(list.read(entry.hash), options, empty)) {
      const auto kept = list.find(entry.hash, computed.key);
      ASSERT_TRUE(kept.has_value()) << computed.key.id;
      EXPECT_EQ(*kept, computed.value);
    }
  }
}

TEST(KeepGenerated, ReturnsTheScenariosThatTheListContained) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  std::vector<GeneratedScenario> part;
  part.push_back({sample_scenario(1, "one"), "x", 1});
  part.push_back({sample_scenario(2, "two"), "x", 2});
  EXPECT_TRUE(keep_generated(list, part).empty());
  part[0] = {sample_scenario(3, "three"), "x", 3};
  EXPECT_EQ(keep_generated(list, part), std::vector<std::size_t>{1});
  EXPECT_EQ(list.size(), 3U);
}

}  // namespace
}  // namespace slalom
