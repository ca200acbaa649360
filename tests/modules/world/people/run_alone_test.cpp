// SPDX-License-Identifier: BSD-3-Clause
#include "crowd_runs.h"

#include <slalom/people/run_alone.h>

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(RunAlone, IsTheMotionOfTheCrowd) {
  RandomEngine random(11);
  const World world = empty_world(5);
  const People people = random_people(random, world, 8, PersonEnd::Stay);
  const PeopleSettings settings;
  const Movers movers = run_alone(world, people, settings, 20);
  EXPECT_NO_THROW(check_movers("alone", movers));
  ASSERT_EQ(movers.size(), people.size());
  Crowd crowd(world, people, settings);
  for (crowd.decide(); crowd.time() < 20; crowd.decide()) {
    for (std::size_t i = 0; i < people.size(); ++i) {
      const auto p = movers[i].position(crowd.time()), q = crowd.states()[i].disc.position;
      EXPECT_TRUE(p.x == q.x && p.y == q.y) << i << " at " << crowd.time();
    }
    crowd.move();
  }
}

TEST(RunAlone, LetsThoseWhoAreThereOnlyForATimeBePresentThen) {
  const World world = empty_world(5);
  People people = {walker(0, {-3, 0}, {{3, 0}}, PersonEnd::Vanish),
                   walker(1, {-3, 2}, {{3, 2}}, PersonEnd::Return), walker(2, {-3, -2}, {{3, -2}})};
  people[0].begin = 1;
  people[2].begin = 100;
  const Movers movers = run_alone(world, people, {}, 30);
  EXPECT_NO_THROW(check_movers("alone", movers));
  EXPECT_FALSE(movers[0].present(0.9));
  EXPECT_TRUE(movers[0].present(1));
  // 5.7 m up to the tolerance of the goal at 1.3 m/s take 4.4 s, in updates of 0.1 s.
  EXPECT_TRUE(movers[0].present(5.3));
  EXPECT_FALSE(movers[0].present(5.5));
  EXPECT_TRUE(movers[1].present(0));
  EXPECT_GT(movers[1].position(4.4).x, 2.2);
  EXPECT_LT(movers[1].position(8.8).x, -2.2);
  EXPECT_GT(movers[1].position(13.2).x, 2.2);
  for (double t = 0; t <= 30; t += 0.5) EXPECT_FALSE(movers[2].present(t));
}

/// The place of one who waits becomes free when the other has left it: 0.5 m at 1.3 m/s.
TEST(RunAlone, LetsPeopleAppearWhenTheirPlaceIsFree) {
  const World world = empty_world(5);
  People people = {walker(0, {-3, 0}, {{3, 0}}), walker(1, {-3, 0}, {{3, 0}})};
  people[1].begin = 0.1;
  const Movers movers = run_alone(world, people, {}, 5);
  EXPECT_FALSE(movers[1].present(0.35));
  EXPECT_TRUE(movers[1].present(0.45));
}

/// Whoever is moved into a neighbor could not start.
TEST(PeopleAlone, ArriveAsWellBesideTheirStartsWhenTheyStartInContact) {
  const World empty = empty_world(5);
  const double gap = 2 * kRadius;
  const std::vector<People> contacts = {
      {walker(0, {0, 0}, {{-4, 0}}), walker(1, {gap, 0}, {{4, 0}})},
      // In the middle of a cross.
      {walker(0, {0, 0}, {{0, 0}}), walker(1, {gap, 0}, {{4, 0}}), walker(2, {-gap, 0}, {{-4, 0}}),
       walker(3, {0, gap}, {{0, 4}}), walker(4, {0, -gap}, {{0, -4}})}};
  for (const People& people : contacts) {
    const World world(empty.scenario().with_people(people), 0.5);
    PeopleAlone alone(world, {});
    const Arrivals arrivals = alone.arrivals(10), beside = alone.arrivals_beside(10);
    for (std::size_t i = 0; i < people.size(); ++i) {
      ASSERT_TRUE(arrivals[i] && beside[i]) << i;
      EXPECT_NEAR(*beside[i], *arrivals[i], 0.1 + 1e-9) << i << ": at most an update";
    }
  }
}

TEST(PeopleAlone, CoverWhatTheCrowdCovers) {
  RandomEngine random(5);
  const World empty = empty_world(5);
  const World world(
      empty.scenario().with_people(random_people(random, empty, 6, PersonEnd::Return)), 0.5);
  PeopleAlone alone(world, {});
  Crowd crowd = alone.start();
  std::vector<std::vector<double>> covered;
  for (; crowd.updates() <= 100; crowd.decide(), crowd.move()) {
    std::vector<double>& now = covered.emplace_back();
    for (std::size_t i = 0; i < 6; ++i) now.push_back(crowd.covered(i));
  }
  // In any order of the questions.
  for (const std::size_t updates : {40, 0, 100, 7})
    EXPECT_EQ(alone.covered(static_cast<int>(updates)), covered[updates]);
}

}  // namespace
}  // namespace slalom::testing
