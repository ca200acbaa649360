// SPDX-License-Identifier: BSD-3-Clause
#include "crowd_runs.h"

#include <slalom/core/math.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

/// Known answers of another program, and of tests in guidelines for simulated crowds (RiMEA 4.1.1;
/// ISO 20414:2020, numbers by PedestrianDynamics/jupedsim, issue 1570), in geometry of our own.

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;

constexpr int kCirclePeople = 250;

/// A point at `radius` (m) in the direction of person i.
TPoint2D place_on_circle(int i, double radius) {
  const math::SinCos angle = math::sin_cos(2 * M_PI * i / kCirclePeople);
  return {radius * angle.cos, radius * angle.sin};
}

People people_of_circle() {
  People people;
  for (int i = 0; i < kCirclePeople; ++i) {
    const TPoint2D start = place_on_circle(i, 200);
    people.push_back(walker(people.size(), start, {start * -1.0}, PersonEnd::Stay, 1));
    people.back().radius = 1.5;
  }
  return people;
}

PeopleSettings settings_of_circle() {
  PeopleSettings settings = settings_of(PeopleModel::Orca);
  settings.period = 0.25;
  settings.horizon = 10;
  settings.sight = 15;
  settings.haste = 2;
  settings.turn = 0;
  settings.keep_apart = false;
  return settings;
}

/// The example Circle of RVO2 (snape/RVO2, 1c25b27), compiled in double: all walk straight up to
/// 70.75 s and then slow down. All have the same distance from the middle, until rounding, which
/// grows by a factor of ten per update, is seen: in RVO2 it is 1.5e-10 m at 71.5 s and 1.5e-8 m at
/// 72 s, when only the mean is the same.
TEST(Standards, WalkTheCircleOfRvo2) {
  const World world = empty_world(220, 10);
  Crowd crowd(world, people_of_circle(), settings_of_circle());
  const auto walk_until = [&](double time) {
    for (; crowd.time() < time; crowd.move()) crowd.decide();
  };
  for (const auto& [time, radius] :
       std::vector<std::pair<double, double>>{{60.0, 140.0000000000},
                                              {70.75, 129.2500000000},
                                              {71.0, 129.0029837242},
                                              {71.25, 128.7621428554},
                                              {71.5, 128.5273230082}}) {
    walk_until(time);
    for (int i = 0; i < kCirclePeople; ++i)
      EXPECT_LT(distance_between(crowd.states()[i].disc.position, place_on_circle(i, radius)), 1e-9)
          << i << " at " << time;
  }
  walk_until(72);
  double sum = 0;
  for (const PersonState& walker : crowd.states()) sum += walker.disc.position.norm();
  EXPECT_NEAR(sum / kCirclePeople, 128.0751480401, 1e-9);
}

/// RiMEA 4.1.1, test 6, and ISO 20414, test 4.
TEST(Standards, WalkRoundACornerWithoutCrossingWalls) {
  const World world = world_with({0, 0, 12, 12}, {rectangle(0, 2, 10, 12)}, 0.1);
  People people;
  for (int i = 0; i < 20; ++i) {
    const int column = i / 3;
    people.push_back(walker(people.size(), {0.4 + 0.6 * column, 0.4 + 0.6 * (i % 3)}, {{11, 11.5}},
                            PersonEnd::Vanish, 1.33));
  }
  for (const PeopleModel model : kModels) {
    PeopleSettings settings = settings_of(model);
    settings.goal_tolerance = 1;
    const auto result = run_crowd(world, people, settings, 60);
    EXPECT_EQ(result.arrived, people.size()) << to_string(model);
    EXPECT_GE(result.wall_gap, -1e-12) << to_string(model);
    EXPECT_GE(result.gap, -1e-12) << to_string(model);
  }
}

/// A room of 20 m x 12 m with doors of 1 m at x = 5 m and 15 m: in one of the long walls, or in
/// both.
World room_with_doors(int doors) {
  std::vector<Polygon> walls;
  for (const double x : {0.0, 5.5, 15.5}) {
    const double to = x == 0 ? 4.5 : x == 5.5 ? 14.5 : 20;
    walls.push_back(rectangle(x, -0.5, to, 0));
    if (doors == 4) walls.push_back(rectangle(x, 12, to, 12.5));
  }
  if (doors == 2) walls.push_back(rectangle(0, 12, 20, 12.5));
  return world_with({0, -2, 20, 14}, walls, 0.1);
}

/// RiMEA 4.1.1, test 9: with half of the doors a room takes about twice as long to empty. RiMEA
/// names no bound. The room is small, for the time of the test.
TEST(Standards, TakeAboutTwiceAsLongToLeaveARoomByHalfOfTheDoors) {
  double times[2];
  for (const int doors : {4, 2}) {
    People people;
    for (int i = 0; i < 200; ++i) {
      const int row = i / 20;
      const TPoint2D start(1 + (i % 20) * 0.95, 1.2 + row * 1.05);
      const TPoint2D goal(start.x < 10 ? 5 : 15, doors == 4 && start.y > 6 ? 13.3 : -1.3);
      people.push_back(walker(people.size(), start, {goal}, PersonEnd::Vanish, 1.33));
    }
    PeopleSettings settings;
    settings.goal_tolerance = 0.7;  // so that people do not meet at the goal
    const auto result = run_crowd(room_with_doors(doors), people, settings, 200);
    EXPECT_EQ(result.arrived, people.size()) << doors;
    EXPECT_GE(result.gap, -1e-12) << doors;
    EXPECT_GE(result.wall_gap, -1e-12) << doors;
    times[doors == 4 ? 0 : 1] = result.last_arrival;
  }
  EXPECT_NEAR(times[1] / times[0], 2, 0.3);
}

/// ISO 20414, test 2: the speed in a corridor is the preferred one. The 20 m up to the tolerance,
/// rounded up to a period.
TEST(Standards, WalkAlongACorridorAtThePreferredSpeed) {
  for (const bool is_upright : {false, true}) {
    const World world =
        world_with(is_upright ? Bounds{-1, -2, 1, 22} : Bounds{-2, -1, 22, 1}, {}, 0.1);
    const TPoint2D goal = is_upright ? TPoint2D(0, 20.3) : TPoint2D(20.3, 0);
    for (const PeopleModel model : kModels)
      for (const double speed : {0.5, 0.8, 1.3, 1.7}) {
        const auto result = run_crowd(world, {walker(0, {0, 0}, {goal}, PersonEnd::Vanish, speed)},
                                      settings_of(model), 60);
        EXPECT_GE(result.last_arrival, 20 / speed - 1e-9) << speed;
        EXPECT_LE(result.last_arrival, 20 / speed + 0.1 + 1e-9) << speed;
      }
  }
}

/// ISO 20414, test 13, and RiMEA 4.1.1, test 16: the speed in a single file of a density. Behind a
/// leader the file has its speed v, and by the law of the model the distance 2 radius + v time gap,
/// if nobody tries to pass a leader who is slow by choice.
TEST(Standards, FollowInASingleFileAtTheDistanceOfItsSpeed) {
  constexpr int kPeople = 8;
  const World world = world_with({-10, -0.45, 100, 0.45}, {}, 0.1);
  for (const double speed : {0.3, 0.6, 0.9, 1.2}) {
    People people;
    for (int i = 0; i < kPeople; ++i)
      people.push_back(walker(people.size(), {-i * 1.1, 0}, {{99, 0}}, PersonEnd::Vanish,
                              i == 0 ? speed : 1.33));
    PeopleSettings settings;
    settings.turn = 0;
    Crowd crowd(world, people, settings);
    for (; crowd.time() < 60; crowd.move()) crowd.decide();
    const auto x = [&](int i) { return crowd.states()[i].disc.position.x; };
    for (int i = 1; i < kPeople; ++i)
      EXPECT_NEAR(x(i - 1) - x(i), 2 * kRadius + speed * settings.time_gap, 1e-3)
          << i << " at " << speed << " m/s";
  }
}

/// s, the last arrival of 40 people who walk through a corridor of 2 m x 10 m between two rooms
/// while `against` come towards them.
double time_of_counter_flow(int against) {
  const World world =
      world_with({-10, 0, 20, 6}, {rectangle(0, 0, 10, 2), rectangle(0, 4, 10, 6)}, 0.1);
  constexpr int kPeople = 40;
  People people;
  for (int i = 0; i < kPeople + against; ++i) {
    const bool back = i >= kPeople;
    const int k = back ? i - kPeople : i, column = k / 8;
    const double x = column * 0.7, y = 0.5 + (k % 8) * 0.7;
    people.push_back(walker(people.size(), {back ? 19.4 - x : -9.4 + x, y}, {{back ? -5.0 : 15, 3}},
                            PersonEnd::Vanish, 1.33));
  }
  PeopleSettings settings;
  settings.goal_tolerance = 1;
  Crowd crowd(world, people, settings);
  for (; crowd.time() < 120; crowd.move()) {
    crowd.decide();
    EXPECT_GE(least_gap(crowd, settings.period), -1e-12);
  }
  double last = 0;
  for (int i = 0; i < kPeople + against; ++i) {
    const auto& arrival = crowd.states()[i].arrival;
    EXPECT_TRUE(arrival) << i << " of " << against;
    if (arrival && i < kPeople) last = std::max(last, *arrival);
  }
  return last;
}

/// ISO 20414, test 6: the more come towards them, the longer it takes. ORCA jams if people keep
/// apart, and is not tested; few people are, for the time of the test.
TEST(Standards, TakeLongerTheMorePeopleComeTowardsThem) {
  double before = 0;
  for (const int against : {0, 10, 20, 40}) {
    const double time = time_of_counter_flow(against);
    EXPECT_GT(time, before) << against;
    before = time;
  }
}

}  // namespace
}  // namespace slalom::testing
