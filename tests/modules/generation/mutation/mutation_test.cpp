// SPDX-License-Identifier: BSD-3-Clause
#include "mutation/scenario_sketch.h"

#include <slalom/generation/mutation.h>
#include <slalom/generation/sample_people.h>
#include <slalom/scenario/grid_map.h>
#include <slalom/scenario/world.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

Scenario posts() {
  Primitives obstacles;
  for (int i = 0; i < 5; ++i) obstacles.discs.push_back({{2.0 + i, 5.0}, 0.3});
  obstacles.polygons.push_back({{{1, 1}, {9, 1}, {9, 1.5}, {1, 1.5}}});
  return Scenario::continuous("posts", {0, 0, 10, 10}, obstacles, {2, 3, 0}, {8, 8});
}

Scenario cells() {
  auto map = make_grid_map(100, 100, 0.1, {0, 0});
  for (int i = 20; i < 80; ++i) map.setCell(i, 50, 0.0f);
  return Scenario::grid("cells", map, {2, 2, 0}, {8, 8});
}

double density(const Scenario& scenario) {
  const Occupancy occupancy = make_occupancy(scenario, 0.1);
  return static_cast<double>(occupancy.count_occupied()) /
         static_cast<double>(occupancy.cells().size());
}

/// Many children of one mutation.
std::vector<Scenario> children(const Scenario& parent, Mutation mutation,
                               const MutationLimits& limits = {}) {
  std::vector<Scenario> all;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    RandomEngine engine(seed);
    if (const auto child = mutate(parent, mutation, limits, engine)) all.push_back(*child);
  }
  return all;
}

TEST(Mutation, EveryKindRespectsTheLimits) {
  const MutationLimits limits;
  for (int kind = 0; kind < kMutations; ++kind) {
    const auto all = children(posts(), static_cast<Mutation>(kind), limits);
    EXPECT_GT(all.size(), 20u) << kind;
    int changed = 0;
    for (const Scenario& child : all) {
      changed += child.hash() != posts().hash() ? 1 : 0;
      EXPECT_GE(std::min(child.bounds().width(), child.bounds().height()),
                limits.min_extent - 1e-9);
      EXPECT_LE(std::max(child.bounds().width(), child.bounds().height()),
                limits.max_extent + 1e-9);
      EXPECT_GE(std::hypot(child.goal().x - child.start().x, child.goal().y - child.start().y),
                limits.min_distance);
      for (const Disc& disc : child.primitives().discs) {
        EXPECT_GT(distance({child.start().x, child.start().y}, disc), limits.robot_radius);
        EXPECT_GT(distance(child.goal(), disc), limits.robot_radius);
      }
    }
    EXPECT_GT(changed, 10) << kind;
  }
}

TEST(Mutation, KeepsMovers) {
  const Movers movers{{"a", 0.3, {{0, {4, 7}}, {5, {6, 7}}}, MoverEnd::Stop}};
  for (const Scenario& parent : {posts(), cells()})
    for (int kind = 0; kind < kMutations; ++kind)
      for (const Scenario& child :
           children(parent.with_movers(movers), static_cast<Mutation>(kind)))
        EXPECT_EQ(child.movers(), movers) << kind;
}

/// Two who cross the room of posts(), which has room for them everywhere but at the posts.
People two_people() {
  Person anna{"anna", 0.25, 1.3, {4, 7}, {{6, 7}, {8, 3}}}, bert{"bert", 0.3, 1, {2, 8}, {{8, 6}}};
  return {anna, bert};
}

TEST(Mutation, KeepsPeopleAndTheirWays) {
  const MutationLimits limits;
  for (const Scenario& parent : {posts(), cells()})
    for (int kind = 0; kind < kMutations; ++kind)
      for (const Scenario& child :
           children(parent.with_people(two_people()), static_cast<Mutation>(kind))) {
        EXPECT_EQ(child.people(), two_people()) << kind;
        EXPECT_EQ(problem_of_people(World(child, limits.resolution), limits.robot_radius), "");
      }
}

TEST(Mutation, OfPeopleChangesOneOfThem) {
  const MutationLimits limits;
  const Scenario parent = posts().with_people(two_people());
  int moved = 0, faster = 0, added = 0, removed = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    RandomEngine engine(seed);
    const auto child = mutate_people(parent, limits, engine);
    if (!child) continue;
    EXPECT_EQ(child->with_people({}).hash(), posts().hash());
    EXPECT_EQ(problem_of_people(World(*child, limits.resolution), limits.robot_radius), "");
    const People& people = child->people();
    added += people.size() == 3 ? 1 : 0;
    removed += people.size() == 1 ? 1 : 0;
    if (people.size() != 2) continue;
    const bool is_anna = people[0] != parent.people()[0];
    const Person &before = parent.people()[is_anna ? 0 : 1], &after = people[is_anna ? 0 : 1];
    EXPECT_EQ(people[is_anna ? 1 : 0], parent.people()[is_anna ? 1 : 0]);
    (after.speed == before.speed ? moved : faster) += 1;
  }
  for (const int count : {moved, faster, added, removed}) EXPECT_GE(count, 5);
  RandomEngine engine(1);
  EXPECT_FALSE(mutate_people(posts(), limits, engine));
}

TEST(Mutation, PutsNeitherAnObstacleNorTheRobotInTheWayOfAMover) {
  // Through the whole room, so that many mutations would.
  const Movers movers{{"a", 0.3, {{0, {1, 7}}, {8, {9, 7}}}, MoverEnd::Stop},
                      {"b", 0.3, {{0, {5, 5}}, {8, {5, 5}}}, MoverEnd::Vanish}};
  const Scenario empty =
      Scenario::continuous("", {0, 0, 10, 10}, {{{{8, 2}, 0.5}}, {}}, {1, 1, 0}, {9, 9});
  int kept = 0, refused = 0;
  for (int kind = 0; kind < kMutations; ++kind) {
    const auto with = children(empty.with_movers(movers), static_cast<Mutation>(kind));
    kept += static_cast<int>(with.size());
    refused += static_cast<int>(children(empty, static_cast<Mutation>(kind)).size()) -
               static_cast<int>(with.size());
    for (const Scenario& child : with) {
      const mrpt::math::TPoint2D start(child.start());
      for (const Mover& mover : movers) {
        const auto begin = mover.position(0);
        EXPECT_GE(std::hypot(begin.x - start.x, begin.y - start.y), 0.3 + 0.25) << kind;
        for (double t = 0; t <= 8; t += 0.01) {
          const auto at = mover.position(t);
          for (const Disc& disc : child.primitives().discs)
            ASSERT_GE(distance(at, disc), 0.3) << kind;
          for (const Polygon& polygon : child.primitives().polygons)
            ASSERT_GE(distance(at, polygon), 0.3) << kind;
        }
      }
    }
  }
  EXPECT_GT(kept, 50);
  EXPECT_GT(refused, 50);
}

TEST(Mutation, EqualSeedsGiveEqualChildren) {
  for (int kind = 0; kind < kMutations; ++kind) {
    RandomEngine a(7), b(7);
    const auto one = mutate(posts(), static_cast<Mutation>(kind), {}, a);
    const auto two = mutate(posts(), static_cast<Mutation>(kind), {}, b);
    ASSERT_EQ(one.has_value(), two.has_value());
    if (one) {
      EXPECT_EQ(one->hash(), two->hash());
    }
  }
}

TEST(Mutation, ChangesTheDensityInTheExpectedDirection) {
  for (const Scenario& child : children(posts(), Mutation::Remove))
    EXPECT_LT(density(child), density(posts()));
  for (const Scenario& child : children(posts(), Mutation::Carve))
    EXPECT_LE(density(child), density(posts()));
  for (const Scenario& child : children(posts(), Mutation::Frame))
    EXPECT_GE(density(child), density(posts()));
  double densest = 0;
  for (const Scenario& child : children(posts(), Mutation::Fill))
    densest = std::max(densest, density(child));
  EXPECT_GT(densest, 0.8);
}

TEST(Mutation, ChangesGridsCellByCell) {
  for (const Mutation kind : {Mutation::Add, Mutation::Fill})
    for (const Scenario& child : children(cells(), kind)) {
      EXPECT_EQ(child.representation(), Representation::Grid);
      EXPECT_GE(density(child), density(cells()));
    }
  for (const Mutation kind : {Mutation::Remove, Mutation::Carve})
    for (const Scenario& child : children(cells(), kind))
      EXPECT_LE(density(child), density(cells()));
  EXPECT_TRUE(children(cells(), Mutation::ScaleWorkspace).empty()) << "a map cannot be scaled";
  EXPECT_FALSE(children(cells(), Mutation::MoveStartGoal).empty());
}

TEST(Mutation, KeepsAWorkspaceOfFixedExtent) {
  MutationLimits fixed;
  fixed.min_extent = fixed.max_extent = 10;
  EXPECT_TRUE(children(posts(), Mutation::ScaleWorkspace, fixed).empty());
  EXPECT_TRUE(children(posts(), Mutation::ExtendWorkspace, fixed).empty());
  for (const Scenario& child : children(posts(), Mutation::CropWorkspace, fixed))
    EXPECT_EQ(child.bounds(), posts().bounds());
}

ScenarioSketch sketch_of(const Scenario& scenario) {
  return sketch(World(scenario, 0.05));
}

TEST(Difference, IsZeroForEqualScenariosAndIncreasesWithChanges) {
  const ScenarioSketch base = sketch_of(posts());
  EXPECT_EQ(difference(base, base), 0);
  // Goal moved by 1 m and 1 m on 10 m x 10 m: half of sqrt(2) / 10, over sqrt(2).
  EXPECT_NEAR(difference(base, sketch_of(posts().with_start_goal({2, 3, 0}, {7, 7}))), 0.05, 1e-12);
  const Scenario wider = Scenario::continuous("wider", {0, 0, 20, 10}, posts().primitives(),
                                              posts().start(), posts().goal());
  EXPECT_GE(difference(base, sketch_of(wider)), 0.5);
}

TEST(Difference, IsRelativeToTheOccupiedBlocks) {
  const auto scene = [](double y) {
    return Scenario::continuous("post", {0, 0, 10, 10}, {{{{5, y}, 0.3}}, {}}, {1, 1, 0}, {9, 9});
  };
  // One post elsewhere: no common occupied block.
  EXPECT_EQ(difference(sketch_of(scene(3)), sketch_of(scene(7))), 1);
}

}  // namespace
}  // namespace slalom
