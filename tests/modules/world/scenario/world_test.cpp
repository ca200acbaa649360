// SPDX-License-Identifier: BSD-3-Clause
#include "aligned_copy.h"
#include "random_worlds.h"

#include <slalom/core/error.h>
#include <slalom/scenario/world.h>

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace slalom {
namespace {

Scenario disc_room() {
  return Scenario::continuous("disc room", {0, 0, 4, 3}, {{{{2, 1.5}, 0.5}}, {}}, {0.5, 0.5, 0},
                              {3.5, 2.5});
}

TEST(World, ComputesEachTableOnce) {
  const World world(disc_room(), 0.05);
  const Occupancy* cells = &world.occupancy();
  const DistanceField* field = &world.distance_field();
  const RayCaster* caster = &world.ray_caster();
  EXPECT_EQ(&world.occupancy(), cells);
  EXPECT_EQ(&world.distance_field(), field);
  EXPECT_EQ(&world.ray_caster(), caster);
}

TEST(World, UsesOneModelForAllTables) {
  const World world(disc_room(), 0.05);
  EXPECT_EQ(world.occupancy().cells(), make_occupancy(disc_room(), 0.05).cells());
  EXPECT_EQ(world.distance_field().clearance({2, 1.5}), 0);
  // The nearest cell's face is at most a cell before the rim at x = 1.5.
  EXPECT_NEAR(world.ray_caster().cast({0.5, 1.52}, 0, 10), 1.0, 0.05 + 1e-9);
  EXPECT_NEAR(world.distance_field().clearance({0.6, 1.52}), 0.6, 1e-9) << "the wall is nearest";
}

TEST(World, IsThreadSafe) {
  const World world(disc_room(), 0.05);
  const RayCaster* seen[2] = {};
  std::thread first([&] { seen[0] = &world.ray_caster(); });
  std::thread second([&] { seen[1] = &world.ray_caster(); });
  first.join();
  second.join();
  EXPECT_EQ(seen[0], seen[1]);
}

/// The tables of a world, as another process maps them.
SharedArray<std::byte> tables_of(const World& world) {
  std::string bytes;
  world.write_tables([&](const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  });
  return aligned_copy(bytes);
}

void expect_equal_answers(const World& a, const World& b, RandomEngine& random) {
  const Bounds bounds = a.occupancy().bounds();
  EXPECT_EQ(a.occupancy().cells(), b.occupancy().cells());
  EXPECT_EQ(bounds, b.occupancy().bounds());
  EXPECT_EQ(a.occupancy().resolution(), b.occupancy().resolution());
  const auto &centers = a.distance_field().centers(), &others = b.distance_field().centers();
  EXPECT_TRUE(std::equal(centers.begin(), centers.end(), others.begin(), others.end()));
  for (int i = 0; i < 200; ++i) {
    const auto p = testing::random_point(random, bounds, 0.2);
    const auto q = testing::random_point(random, bounds, 0.2);
    const double heading = uniform_real(random, -M_PI, M_PI), limit = uniform_real(random, 0, 9);
    EXPECT_EQ(a.distance_field().clearance(p), b.distance_field().clearance(p));
    EXPECT_EQ(a.distance_field().clearance_lower_bound(p),
              b.distance_field().clearance_lower_bound(p));
    EXPECT_EQ(a.distance_field().segment_clearance(p, q, limit),
              b.distance_field().segment_clearance(p, q, limit));
    EXPECT_EQ(a.distance_field().outline_clearance({p, q, {p.x, q.y}}),
              b.distance_field().outline_clearance({p, q, {p.x, q.y}}));
    EXPECT_EQ(a.ray_caster().cast(p, heading, limit), b.ray_caster().cast(p, heading, limit));
    std::vector<float> scan(181), other(181);
    a.ray_caster().cast_scan({p.x, p.y, heading}, {}, scan.data());
    b.ray_caster().cast_scan({p.x, p.y, heading}, {}, other.data());
    EXPECT_EQ(scan, other);
  }
}

TEST(World, AnswersFromTheTablesOfAnotherProcessAsFromItsOwn) {
  RandomEngine random(14);
  for (int i = 0; i < 30; ++i) {
    const Bounds bounds = {uniform_real(random, -9, 0), -1, 7, 8};
    const Scenario scenario = Scenario::continuous(
        "", bounds, testing::random_primitives(random, bounds, 4), {0.5, 0.5, 0}, {3.5, 2.5});
    const World world(scenario, uniform_real(random, 0.03, 0.4));
    const SharedArray<std::byte> tables = tables_of(world);
    const World mapped(scenario, world.requested_resolution(), tables);
    EXPECT_GE(static_cast<const void*>(mapped.distance_field().centers().data()), tables.begin());
    EXPECT_LT(static_cast<const void*>(mapped.distance_field().centers().data()), tables.end());
    expect_equal_answers(world, mapped, random);
  }
}

TEST(World, TablesThatAreNotCompleteAreRefused) {
  const SharedArray<std::byte> tables = tables_of(World(disc_room(), 0.5));
  for (std::size_t size = 0; size < tables.size(); size += 8)
    EXPECT_THROW(World(disc_room(), 0.5, {tables.owner(), size}), Error) << size;
  EXPECT_NO_THROW(World(disc_room(), 0.5, tables));
}

TEST(World, ReportsAnInvalidResolutionOnFirstUse) {
  const World world(disc_room(), 0);
  EXPECT_EQ(world.scenario().name(), "disc room");
  EXPECT_THROW(world.occupancy(), Error);
  EXPECT_THROW(world.ray_caster(), Error);
}

}  // namespace
}  // namespace slalom
