// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/distance.h>
#include <slalom/generation/sample_people.h>
#include <slalom/references/disc_path.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// A room of 10 m x 8 m with posts.
Scenario room_with_posts(std::uint64_t seed, int count) {
  RandomEngine engine(seed);
  Primitives obstacles;
  for (int i = 0; i < count; ++i) {
    const double x = uniform_real(engine, 2, 9);
    obstacles.discs.push_back({{x, uniform_real(engine, 1, 7)}, uniform_real(engine, 0.1, 0.6)});
  }
  return Scenario::continuous("posts", {0, 0, 10, 8}, obstacles, {1, 4, 0}, {9.5, 4});
}

TEST(SamplePeople, HaveRoomWhereTheyStartAndEndAndAWayBetween) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const World world(room_with_posts(seed, 8), 0.05);
    PeopleOptions options;
    options.count = 6;
    RandomEngine engine(seed), same(seed);
    const People people = sample_people(world, 0.25, options, engine);
    EXPECT_EQ(people, sample_people(world, 0.25, options, same));
    ASSERT_EQ(people.size(), 6U);
    EXPECT_EQ(world.scenario().with_people(people).people(), people);
    for (const Person& person : people) {
      const TPoint2D& goal = person.route.at(0);
      std::string reason;
      EXPECT_TRUE(shortest_disc_path(world.occupancy(), person.radius, person.start, goal, reason));
      EXPECT_TRUE(person.radius >= 0.2 && person.radius <= 0.3);
      EXPECT_TRUE(person.speed >= 0.8 && person.speed <= 1.5);
      EXPECT_GE(distance_between(person.start, goal), 3);
      EXPECT_GE(distance_between(person.start, TPoint2D(1, 4)), person.radius + 0.25 + 1);
      EXPECT_GE(distance_between(goal, TPoint2D(9.5, 4)), person.radius + 0.25 + 1);
    }
  }
}

TEST(SamplePeople, EachDependsOnlyOnThoseBeforeIt) {
  const World world(room_with_posts(7, 5), 0.05);
  PeopleOptions options;
  options.count = 3;
  RandomEngine engine(4), same(4);
  const People three = sample_people(world, 0.25, options, engine);
  options.count = 2;
  EXPECT_EQ(sample_people(world, 0.25, options, same), People(three.begin(), three.begin() + 2));
}

TEST(SamplePeople, WithoutRoomAreAnErrorThatNamesTheScenario) {
  const World world(room_with_posts(7, 5), 0.05);
  PeopleOptions options;
  options.count = 1;
  options.min_radius = options.max_radius = 4;  // half the height of the room
  EXPECT_TRUE(throws_error(ErrorKind::Job, "posts: no room for a person of radius 4.00 m",
                           {"smaller people"}, [&] {
                             RandomEngine engine(1);
                             sample_people(world, 0.25, options, engine);
                           }));
}

TEST(SamplePeople, WithoutAProblemStartFreelyAndHaveAWay) {
  Primitives wall;  // with a door of 0.8 m
  wall.polygons = {{{{5, 0}, {5.1, 0}, {5.1, 3.5}, {5, 3.5}}},
                   {{{5, 4.5}, {5.1, 4.5}, {5.1, 8}, {5, 8}}}};
  const Scenario room = Scenario::continuous("room", {0, 0, 10, 8}, wall, {1, 4, 0}, {9.5, 4});
  const auto problem = [&](double radius, const TPoint2D& start, std::vector<TPoint2D> route) {
    const Person anna{"anna", radius, 1, start, std::move(route)};
    return problem_of_people(World(room.with_people({anna}), 0.05), 0.25);
  };
  EXPECT_EQ(problem(0.3, {2, 2}, {{8, 2}, {2, 6}}), "");
  EXPECT_EQ(problem(0.3, {0.2, 2}, {{8, 2}}), "person 'anna' starts in a wall");
  EXPECT_EQ(problem(0.3, {1.5, 4}, {{8, 2}}), "person 'anna' touches the robot at the start");
  EXPECT_EQ(problem(0.3, {1.6, 4}, {{8, 2}}), "");
  EXPECT_EQ(problem(0.6, {2, 2}, {{3, 2}, {8, 2}}), "person 'anna' has no way to its goal");
  EXPECT_EQ(problem(0.3, {2, 2}, {{5.05, 2}}), "person 'anna' has no way to its goal");
}

}  // namespace
}  // namespace slalom
