// SPDX-License-Identifier: BSD-3-Clause
#include "crowd_runs.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;

constexpr double kRobotRadius = 0.3;  // m

RobotDisc robot_at(const TPoint2D& position, std::vector<bool> noticed,
                   const TPoint2D& velocity = {0, 0}) {
  return {{position, velocity, kRobotRadius}, std::move(noticed)};
}

/// The result of one person and a robot that stands, after some updates.
Hindrance hindrance_of(const World& world, const Person& person, PeopleModel model,
                       const std::optional<RobotDisc>& robot, int updates) {
  Crowd crowd(world, {person}, settings_of(model));
  for (int k = 0; k < updates; ++k) {
    crowd.decide(robot);
    crowd.move();
  }
  return crowd.states()[0].hindrance;
}

TEST(Hindrance, OfTheSpeedModelIsTheWayThatTheGapTakes) {
  // The robot is 1 m ahead, where it does not turn the direction: somebody who walks at 1.3 m/s
  // goes on at gap / (1 s) = 1 m/s.
  const World world = empty_world(6);
  Crowd crowd(world, {walker(0, {-2, 0}, {{4, 0}})}, settings_of(PeopleModel::Speed));
  crowd.decide();
  crowd.move();
  const double ahead = crowd.states()[0].disc.position.x + kRadius + 1 + kRobotRadius;
  crowd.decide(robot_at({ahead, 0}, {true}));
  const Hindrance& one = crowd.states()[0].hindrance;
  EXPECT_TRUE(one.is_noticed);
  EXPECT_EQ(one.updates, 1);
  EXPECT_NEAR(one.time, 0.1 * (1.3 - 1) / 1.3, 1e-12);
  EXPECT_NEAR(one.speed_change, 0.3, 1e-12);
}

TEST(Hindrance, IsNoneAloneOrByARobotThatIsFarAwayOrNotNoticed) {
  const World world = empty_world(12);
  const Person person = walker(0, {-6, 0}, {{2, 0}});
  for (const PeopleModel model : kModels) {
    EXPECT_EQ(hindrance_of(world, person, model, {}, 80), Hindrance());
    EXPECT_EQ(hindrance_of(world, person, model, robot_at({0, 0}, {false}), 80), Hindrance());
    Hindrance far_away;
    far_away.is_noticed = true;
    EXPECT_EQ(hindrance_of(world, person, model, robot_at({0, 9}, {true}), 80), far_away);
  }
}

TEST(Hindrance, BehindAWallIsNone) {
  const World world = world_with({-6, -6, 6, 6}, {rectangle(-6, 1, 6, 1.1)}, 0.1);
  for (const PeopleModel model : kModels) {
    const Hindrance behind =
        hindrance_of(world, walker(0, {-4, 0}, {{4, 0}}), model, robot_at({0, 1.6}, {true}), 40);
    EXPECT_EQ(behind.updates, 0);
    EXPECT_EQ(behind.time, 0);
  }
}

TEST(Hindrance, InABlockedCorridorIsMostOfTheTimeThere) {
  // The person could be at the robot after (5 - 0.55) / 1.3 = 3.4 s of 20 s, and cannot pass. By
  // the walls it would walk somewhat slower than it prefers.
  const World world = world_with({-6, -0.4, 6, 0.4}, {}, 0.1);
  for (const PeopleModel model : kModels) {
    const Hindrance blocked =
        hindrance_of(world, walker(0, {-5, 0}, {{5, 0}}), model, robot_at({0, 0}, {true}), 200);
    EXPECT_GT(blocked.time, 0.8 * (20 - 3.4)) << to_string(model);
    EXPECT_LT(blocked.time, 20) << to_string(model);
    // The velocities differ by the lost speed at least.
    EXPECT_GE(blocked.speed_change * 0.1 / 1.3, blocked.time - 1e-9);
  }
}

TEST(Hindrance, EndsWithTheArrival) {
  // The robot covers the goal.
  const World world = empty_world(6);
  for (const PeopleModel model : kModels) {
    const Person person = walker(0, {-4, 0}, {{2, 0}});
    const RobotDisc robot = robot_at({2.1, 0}, {true});
    EXPECT_EQ(hindrance_of(world, person, model, robot, 200),
              hindrance_of(world, person, model, robot, 400));
  }
}

/// Up to an arrival: a copy of the crowd, of one person, decides without the robot.
TEST(Hindrance, IsTheDifferenceToACrowdWithoutTheRobot) {
  const World world = world_with({-6, -6, 6, 6}, {rectangle(-1, -1, 1, 1)}, 0.1);
  RandomEngine random(1);
  double changes = 0;  // m/s
  for (const PeopleModel model : kModels)
    for (int run = 0; run < 20; ++run) {
      const People people = random_people(random, world, 1, PersonEnd::Stay);
      Crowd crowd(world, people, settings_of(model));
      double change = 0;  // m/s
      RobotDisc robot = robot_at((people[0].start + people[0].route[0]) * 0.5, {true});
      for (int k = 0; k < 150; ++k) {
        robot.disc.velocity = {uniform_real(random, -1, 1), uniform_real(random, -1, 1)};
        Crowd without = crowd;
        crowd.decide(robot);
        without.decide();
        const PersonState &a = crowd.states()[0], &b = without.states()[0];
        if (a.is_present && a.arrival == b.arrival) change += (b.chosen - a.chosen).norm();
        if (a.arrival) break;
        crowd.move();
        robot.disc.position += robot.disc.velocity * 0.1;
      }
      EXPECT_NEAR(crowd.states()[0].hindrance.speed_change, change, 1e-9);
      changes += change;
    }
  EXPECT_GT(changes, 40);
}

TEST(Hindrance, ConcernsOnlyThoseWhoNoticeTheRobot) {
  const World world = empty_world(6, 0.5);
  RandomEngine random(2);
  for (const PeopleModel model : kModels) {
    const RobotDisc standing = robot_at({0, 0}, {});
    const People people = random_people(random, world, 12, PersonEnd::Return, {standing.disc});
    RobotDisc robot = standing;
    for (std::size_t i = 0; i < people.size(); ++i) robot.noticed.push_back(i % 2 == 0);
    Crowd crowd(world, people, settings_of(model));
    for (int k = 0; k < 300; ++k) {
      crowd.decide(robot);
      crowd.move();
    }
    double sum = 0;
    for (std::size_t i = 0; i < people.size(); ++i) {
      const Hindrance& hindrance = crowd.states()[i].hindrance;
      sum += hindrance.time;
      EXPECT_TRUE(robot.noticed[i] || hindrance == Hindrance());
    }
    EXPECT_GT(sum, 0) << to_string(model);
  }
}

}  // namespace
}  // namespace slalom::testing
