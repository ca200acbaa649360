// SPDX-License-Identifier: BSD-3-Clause
#include "io_sample.h"

#include <slalom/campaign/describe_scenario.h>
#include <slalom/io/scenario_list.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(DescribeScenario, ComputesAllDescriptorsAndStoresThem) {
  const TemporaryFolder folder;
  const Scenario scenario = sample_scenario(1);
  const std::string path = folder / "a.scenarios";
  std::vector<KeyedValue> first;
  {
    ScenarioList list = ScenarioList::create(path);
    first = describe_scenario(scenario, {}, list);
    EXPECT_EQ(first.size(), all_descriptors().size());
  }
  ScenarioList list = ScenarioList::open(path);
  for (const Descriptor& d : all_descriptors()) {
    const World world(scenario, 0.05);
    const DescriptorContext context{world, Footprint::disc(0.25), 8, nullptr};
    EXPECT_TRUE(list.find(scenario.hash(), d.key(context)).has_value()) << d.info.id;
  }
}

TEST(DescribeScenario, DetourRatioUsesTheShortestPath) {
  MemoryDescriptorStore store;
  DescribeOptions options;
  options.ids = {"detour_ratio"};
  const auto values = describe_scenario(sample_scenario(1), options, store);
  ASSERT_EQ(values.size(), 1U);
  EXPECT_GE(values[0].value.number(), 1);
  EXPECT_LT(values[0].value.number(), 1.5);
}

}  // namespace
}  // namespace slalom
