#include <slalom/core/error.h>
#include <slalom/scenario/world.h>

#include <gtest/gtest.h>

#include <thread>

namespace slalom {
namespace {

Scenario sample() {
  return Scenario::continuous("sample", {0, 0, 4, 3}, {{{{2, 1.5}, 0.5}}, {}}, {0.5, 0.5, 0},
                              {3.5, 2.5});
}

TEST(World, ComputesEachTableOnce) {
  const World world(sample(), 0.05);
  const Occupancy* cells = &world.occupancy();
  const DistanceField* field = &world.distance_field();
  const RayCaster* caster = &world.ray_caster();
  EXPECT_EQ(&world.occupancy(), cells);
  EXPECT_EQ(&world.distance_field(), field);
  EXPECT_EQ(&world.ray_caster(), caster);
}

TEST(World, UsesOneModelForAllTables) {
  const World world(sample(), 0.05);
  EXPECT_EQ(world.occupancy().cells(), make_occupancy(sample(), 0.05).cells());
  EXPECT_EQ(world.distance_field().clearance({2, 1.5}), 0);
  // The nearest cell's face is at most a cell before the rim at x = 1.5.
  EXPECT_NEAR(world.ray_caster().cast({0.5, 1.52}, 0, 10), 1.0, 0.05 + 1e-9);
  EXPECT_NEAR(world.distance_field().clearance({0.6, 1.52}), 0.6, 1e-9) << "the wall is nearest";
}

TEST(World, IsThreadSafe) {
  const World world(sample(), 0.05);
  const RayCaster* seen[2] = {};
  std::thread first([&] { seen[0] = &world.ray_caster(); });
  std::thread second([&] { seen[1] = &world.ray_caster(); });
  first.join();
  second.join();
  EXPECT_EQ(seen[0], seen[1]);
}

TEST(World, ReportsAnInvalidResolutionOnFirstUse) {
  const World world(sample(), 0);
  EXPECT_EQ(world.scenario().name(), "sample");
  EXPECT_THROW(world.occupancy(), Error);
  EXPECT_THROW(world.ray_caster(), Error);
}

}  // namespace
}  // namespace slalom
