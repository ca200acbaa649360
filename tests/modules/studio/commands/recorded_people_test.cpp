// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/commands/recorded_people.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// With a wall of 0.2 m at x from 5 to 5.2 m, up to y = 3 m.
Scenario room() {
  return Scenario::continuous("room", {0, 0, 10, 6}, {{}, {{{{5, 0}, {5.2, 0}, {5.2, 3}, {5, 3}}}}},
                              {1, 5, 0}, {9, 5});
}

People people_of(const Movers& movers) {
  return recorded_people(World(room(), 0.05), movers);
}

Mover walk(const std::string& id, const std::vector<Waypoint>& waypoints) {
  return {id, 0.3, waypoints, MoverEnd::Vanish};
}

TEST(RecordedPeople, WalkFromTheFirstToTheLastPositionAndVanish) {
  // 2 s at 1 m/s, 10 s of rest, 3 s at 1.5 m/s: of the 5 s of walking more than half at 1.5 m/s.
  const People people =
      people_of({walk("a", {{2, {1, 4}}, {4, {3, 4}}, {14, {3, 4.1}}, {17, {7.5, 4.1}}})});
  const Person expected{"a", 0.3, 1.5, {1, 4}, {{7.5, 4.1}}, 2, PersonEnd::Vanish};
  EXPECT_EQ(people, People{expected});
  EXPECT_NO_THROW(room().with_people(people));
}

TEST(RecordedPeople, HaveTheSpeedOfTheirWayIfTheyAreAlwaysSlow) {
  EXPECT_DOUBLE_EQ(people_of({walk("a", {{0, {1, 4}}, {10, {2, 4}}})})[0].speed, 0.1);
}

TEST(RecordedPeople, AreNotFasterByTheNoiseOfPositions) {
  // 1 m/s, 25 positions per second, to and fro by 4 cm across: sqrt(2) m/s from one to the next.
  std::vector<Waypoint> waypoints;
  for (int i = 0; i <= 100; ++i)
    waypoints.push_back({0.04 * i, {1 + 0.04 * i, 4 + 0.04 * (i % 2)}});
  EXPECT_NEAR(people_of({walk("a", waypoints)})[0].speed, 1, 0.005)
      << "at most 11 steps of 0.04 m, 0.04 m across: 0.442 m in 0.44 s";
}

TEST(RecordedPeople, StandIfTheyNeverLeaveTheDiscOfTheirStart) {
  const People people = people_of({walk("a", {{1, {1, 4}}, {2, {1.2, 4}}, {3, {1, 3.8}}})});
  const Person expected{"a", 0.3, 1.3, {1, 4}, {{1, 4}}, 1, PersonEnd::Stay};
  EXPECT_EQ(people, People{expected});
}

TEST(RecordedPeople, StartAndEndWhereTheyHaveRoom) {
  // The border, and the wall, are nearer than 0.3 m up to x = 0.3 m and from x = 4.7 m on.
  const People people =
      people_of({walk("in", {{0, {-1, 1}}, {1, {0.25, 1}}, {2, {1.45, 1}}, {3, {3, 1}}}),
                 walk("out", {{0, {4.05, 2}}, {1, {4.85, 2}}, {2, {5.1, 2}}})});
  EXPECT_NEAR(people[0].start.x, 0.35, 1e-9) << "of steps of 0.1 m";
  EXPECT_NEAR(people[0].begin, 1 + 0.1 / 1.2, 1e-9);
  EXPECT_NEAR(people[1].route.back().x, 4.65, 1e-9);
}

TEST(RecordedPeople, StartApartAtTheBeginning) {
  const Mover first = walk("a", {{0, {1, 4}}, {1, {2, 4}}}),
              second = walk("b", {{0, {1.5, 4}}, {0.5, {2, 4}}, {1, {3, 4}}});
  const People people = people_of({first, second});
  EXPECT_NEAR(people[1].begin, 0.1, 1e-9) << "0.5 m apart at first, less than twice 0.3 m";
  EXPECT_NO_THROW(room().with_people(people));
  const Mover still = walk("c", {{3, {1.5, 4}}, {4, {1.5, 4}}});
  EXPECT_EQ(people_of({first, still})[1].begin, 3) << "the place is free by then";
  EXPECT_TRUE(throws_error(ErrorKind::File, "room: person 'c'", {"no position with room", "0.3 m"},
                           [&] {
                             people_of({walk("d", {{0, {1, 4}}, {1, {1, 4}}}), still});
                           }))
      << "who stands never makes place";
}

TEST(RecordedPeople, WalkOverTheGoalsOfMoversThatDoNotVanish) {
  const std::vector<Waypoint> goals = {{0, {1, 4}}, {2, {3, 4}}, {3, {3, 5}}};
  Mover mover{"a", 0.3, goals, MoverEnd::Stop};
  const Person expected{"a", 0.3, 1, {1, 4}, {{3, 4}, {3, 5}}, 0, PersonEnd::Stay};
  EXPECT_EQ(people_of({mover}), People{expected});
  mover.waypoints.push_back({5, {1, 4}});
  mover.after = MoverEnd::Loop;
  Person to_and_fro = expected;
  to_and_fro.after = PersonEnd::Return;
  EXPECT_EQ(people_of({mover}), People{to_and_fro});
}

TEST(RecordedPeople, AreLeftOutIfTheyAreNeverInTheBounds) {
  const Mover outside = walk("a", {{0, {-3, 4}}, {1, {-2, 4}}}),
              inside = walk("b", {{0, {2, 4}}, {1, {3, 4}}});
  const People people = people_of({outside, inside});
  ASSERT_EQ(people.size(), 1U);
  EXPECT_EQ(people[0].id, "b");
  EXPECT_TRUE(throws_error(ErrorKind::File, "room", {"nobody is in its bounds"},
                           [&] { people_of({outside}); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "room: person 'w'",
                           {"no position with room", "from walls"}, [&] {
                             people_of({walk("w", {{0, {5.1, 1}}, {1, {5.1, 2}}})});
                           }));
}

}  // namespace
}  // namespace slalom
