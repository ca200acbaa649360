#include "small_worlds.h"

#include <gtest/gtest.h>

#include <set>

namespace slalom {
namespace {

const std::vector<std::string> kOfPlace = {"density", "clearness", "confinement"};

TEST(DescriptorLaws, SharesStayBetweenZeroAndOne) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const World world(random_room(seed, static_cast<int>(seed) * 2), 0.05);
    for (const std::string& id : kOfPlace) {
      const double value = value_of(id, context_of(world));
      EXPECT_GE(value, 0) << id;
      EXPECT_LE(value, 1) << id;
    }
  }
}

TEST(DescriptorLaws, MovingTheWholeScenarioChangesNothing) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    // Whole metres, so that cells fall on the same parts of the obstacles.
    const World here(random_room(seed, 12), 0.05), there(random_room(seed, 12, {-7, 13}), 0.05);
    for (const std::string& id : kOfPlace)
      EXPECT_NEAR(value_of(id, context_of(here)), value_of(id, context_of(there)), 2e-3) << id;
    EXPECT_NEAR(value_of("density", context_of(here)), value_of("density", context_of(there)),
                1e-4);
  }
}

TEST(DescriptorLaws, MoreObstaclesNeverLessDenseNorClearer) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    double density = -1, clearness = 2;
    for (int discs = 0; discs <= 24; discs += 4) {  // the same engine: more of the same obstacles
      const World world(random_room(seed, discs), 0.05);
      const DescriptorContext context = context_of(world);
      EXPECT_GE(value_of("density", context), density);
      EXPECT_LE(value_of("clearness", context), clearness + 1e-12);
      density = value_of("density", context);
      clearness = value_of("clearness", context);
    }
  }
}

TEST(DescriptorLaws, FinerCellsComeNearerToTheTrueDensity) {
  Primitives obstacles;
  obstacles.discs.push_back({{5, 5}, 2});
  const Scenario scenario =
      Scenario::continuous("disc", {0, 0, 10, 10}, obstacles, {1, 1, 0}, {9, 9});
  const double exact = 3.14159265358979323846 * 4 / 100;
  double previous = 1;
  for (const double resolution : {0.4, 0.2, 0.1, 0.05, 0.025}) {
    const World world(scenario, resolution);
    const double error = value_of("density", context_of(world)) - exact;
    EXPECT_GT(error, 0) << "touched cells are occupied: never less than the truth";
    EXPECT_LT(error, 0.65 * previous) << "about half for half the cell";
    previous = error;
  }
}

TEST(DescriptorLaws, TheSameScenarioGivesTheSameBits) {
  const World a(random_room(3, 15), 0.05), b(random_room(3, 15), 0.05);
  for (const std::string& id : kOfPlace)
    EXPECT_EQ(descriptor(id).compute(context_of(a)), descriptor(id).compute(context_of(b)));
}

TEST(DescriptorLaws, IdsAreDistinctAndDescribed) {
  std::set<std::string> ids;
  for (const auto& d : all_descriptors()) {
    const QuantityInfo info = d->info();
    EXPECT_TRUE(ids.insert(info.id).second) << info.id;
    EXPECT_FALSE(info.name.empty());
    EXPECT_FALSE(info.unit.empty());
    EXPECT_GE(info.version, 1);
  }
}

}  // namespace
}  // namespace slalom
