// SPDX-License-Identifier: BSD-3-Clause
#include "planted_methods.h"

#include <slalom/falsification/neighbors.h>

#include <gtest/gtest.h>

#include <set>

namespace slalom {
namespace {

Scenario empty_task(double side, double distance) {
  return Scenario::continuous("task", {0, 0, side, side}, {}, {1, side / 2, 0},
                              {1 + distance, side / 2});
}

NeighborOptions ten_runs() {
  NeighborOptions options;
  options.runs_per_failure = 10;
  return options;
}

TEST(Neighbors, AreSuccessesOfASimilarTaskAndEachIsUsedOnce) {
  const FalsificationSetup setup = planted_setup("none");
  // A micro-world and a family: 6 m x 6 m are only micro-worlds.
  const std::vector<Scenario> failures = {empty_task(6, 4), empty_task(12, 9)};
  const auto neighbors = successful_neighbors(setup, failures, ten_runs());
  ASSERT_TRUE(neighbors);
  ASSERT_EQ(neighbors->size(), 2u);
  std::set<std::string> hashes;
  for (const auto& group : *neighbors) {
    EXPECT_EQ(group.size(), 3u);
    for (const Scenario& scenario : group) {
      EXPECT_TRUE(hashes.insert(scenario.hash()).second);
      const auto method = setup.method.make(setup.run.robot, setup.run.sensor);
      EXPECT_EQ(run_trial(World(scenario, 0.05), setup, *method).outcome, Outcome::Success);
    }
  }
  for (const Scenario& scenario : (*neighbors)[0]) EXPECT_EQ(scenario.bounds().width(), 6);
  for (const Scenario& scenario : (*neighbors)[1]) EXPECT_GT(scenario.bounds().width(), 6);
}

TEST(Neighbors, AreTheSameEachTime) {
  const FalsificationSetup setup = planted_setup("none");
  const std::vector<Scenario> failures = {empty_task(6, 4)};
  const auto first = successful_neighbors(setup, failures, ten_runs());
  const auto second = successful_neighbors(setup, failures, ten_runs());
  ASSERT_TRUE(first && second);
  ASSERT_FALSE((*first)[0].empty());
  for (std::size_t i = 0; i < (*first)[0].size(); ++i)
    EXPECT_EQ((*first)[0][i].hash(), (*second)[0][i].hash());
}

TEST(Neighbors, AreNoneWhenInterrupted) {
  NeighborOptions options = ten_runs();
  options.interrupted = [] { return true; };
  EXPECT_FALSE(successful_neighbors(planted_setup("none"), {empty_task(6, 4)}, options));
}

TEST(Neighbors, OneRemovalVariantsLackOneObstacleEach) {
  const Scenario scenario = passage();
  const std::size_t obstacles =
      scenario.primitives().discs.size() + scenario.primitives().polygons.size();
  const auto variants = one_removal_variants(scenario, 0.05);
  ASSERT_EQ(variants.size(), obstacles);
  std::set<std::string> hashes;
  for (const Scenario& variant : variants) {
    EXPECT_EQ(variant.primitives().discs.size() + variant.primitives().polygons.size(),
              obstacles - 1);
    hashes.insert(variant.hash());
  }
  EXPECT_EQ(hashes.size(), obstacles);
}

}  // namespace
}  // namespace slalom
