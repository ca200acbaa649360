// SPDX-License-Identifier: BSD-3-Clause
#include "small_worlds.h"

#include <slalom/descriptors/descriptor_cache.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

int computations = 0;

/// Counts its computations.
const Descriptor kCounting = {{"counting", 1, "Counting", "-", Direction::None},
                              {[](const DescriptorContext& context) {
                                return "robot_radius=" + std::to_string(context.robot_radius());
                              }},
                              [](const DescriptorContext&) { return Value::of(++computations); }};

TEST(DescriptorCache, ComputesAValueOncePerScenarioAndParameters) {
  MemoryDescriptorStore store;
  computations = 0;
  const World a(random_room(1, 3), 0.1), b(random_room(2, 3), 0.1);
  EXPECT_EQ(describe(kCounting, context_of(a), store).value, Value::of(1));
  EXPECT_EQ(describe(kCounting, context_of(a), store).value, Value::of(1));
  EXPECT_EQ(describe(kCounting, context_of(b), store).value, Value::of(2));
  EXPECT_EQ(describe(kCounting, context_of(a, 0.3), store).value, Value::of(3));
  EXPECT_EQ(describe(kCounting, context_of(a), store).value, Value::of(1));
  EXPECT_EQ(computations, 3);
}

TEST(DescriptorCache, ParametersContainTheDependencies) {
  const World room(random_room(1, 3), 0.1);
  const World grid = drawn_world({"S.G"});
  EXPECT_EQ(descriptor("density").key(context_of(room)).parameters, "resolution=0.1");
  EXPECT_EQ(descriptor("density").key(context_of(grid)).parameters, "");
  EXPECT_EQ(descriptor("clearness").key(context_of(grid, 0.25, 5)).parameters, "sensor_range=5");
  EXPECT_EQ(descriptor("detour_ratio").key(context_of(grid, 0.3)).parameters, "robot_radius=0.3");
}

}  // namespace
}  // namespace slalom
