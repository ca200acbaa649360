#include "small_worlds.h"

#include <slalom/descriptors/descriptor_cache.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// Counts how often it is computed.
class Counting : public Descriptor {
 public:
  QuantityInfo info() const override { return {"counting", 1, "Counting", "-", Direction::None}; }
  std::string parameters(const DescriptorContext& context) const override {
    return "robot_radius=" + std::to_string(context.robot_radius());
  }
  Value compute(const DescriptorContext&) const override { return Value::of(++computed); }
  mutable int computed = 0;
};

TEST(DescriptorCache, AValueIsComputedOnceForEachScenarioAndParameters) {
  MemoryDescriptorStore store;
  const Counting counting;
  const World a(random_room(1, 3), 0.1), b(random_room(2, 3), 0.1);
  EXPECT_EQ(describe(counting, context_of(a), &store), Value::of(1));
  EXPECT_EQ(describe(counting, context_of(a), &store), Value::of(1));
  EXPECT_EQ(describe(counting, context_of(b), &store), Value::of(2));
  EXPECT_EQ(describe(counting, context_of(a, 0.3), &store), Value::of(3));
  EXPECT_EQ(describe(counting, context_of(a), &store), Value::of(1));
  EXPECT_EQ(counting.computed, 3);
}

TEST(DescriptorCache, WithoutAStoreEveryTimeIsNew) {
  const Counting counting;
  const World world(random_room(1, 3), 0.1);
  describe(counting, context_of(world));
  describe(counting, context_of(world));
  EXPECT_EQ(counting.computed, 2);
}

TEST(DescriptorCache, ParametersTellApartWhatValuesDependOn) {
  const World room(random_room(1, 3), 0.1);
  const World grid = drawn_world({"S.G"});
  EXPECT_EQ(descriptor("density").parameters(context_of(room)), "resolution=0.1");
  EXPECT_EQ(descriptor("density").parameters(context_of(grid)), "");
  EXPECT_EQ(descriptor("clearness").parameters(context_of(grid, 0.25, 5)), "sensor_range=5");
  EXPECT_EQ(descriptor("detour_ratio").parameters(context_of(grid, 0.3)), "robot_radius=0.3");
}

}  // namespace
}  // namespace slalom
