// SPDX-License-Identifier: BSD-3-Clause
#include "crowd_runs.h"
#include "error_text.h"

#include <slalom/core/math.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;

/// RiMEA 4.1.1, test 1: 40 m at 1.33 m/s in 26 to 34 s. With a period of 0.1 s the 40 m up to the
/// tolerance take 30.075 s, rounded up.
TEST(Crowd, WalksAlongACorridorInTheTimeOfRimea1) {
  const World world = world_with({-2, -1, 45, 1}, {}, 0.1);
  for (const PeopleModel model : kModels) {
    const auto result = run_crowd(world, {walker(0, {0, 0}, {{40.3, 0}}, PersonEnd::Vanish, 1.33)},
                                  settings_of(model), 60);
    EXPECT_NEAR(result.last_arrival, 30.1, 1e-9);
  }
}

/// The symmetric crossing of a circle: all want through the middle.
TEST(Crowd, CrossesACircleWithoutOverlap) {
  for (const PeopleModel model : kModels)
    for (int n = 2; n <= 50; ++n) {
      const double radius = std::max(4.0, 0.2 * n);
      const World world = empty_world(radius + 3, 1);
      People people;
      for (int i = 0; i < n; ++i) {
        const math::SinCos angle = math::sin_cos(2 * M_PI * i / n);
        const TPoint2D start(radius * angle.cos, radius * angle.sin);
        people.push_back(walker(people.size(), start, {start * -1.0}));
      }
      const auto result = run_crowd(world, people, settings_of(model), 120);
      EXPECT_EQ(result.arrived, people.size()) << n << " " << to_string(model);
      EXPECT_GE(result.gap, -1e-12) << n;
    }
}

/// Straight ways to the via point, on to the goal, and back.
TEST(Crowd, CoversItsRouteAtItsSpeed) {
  const World world = empty_world(6);
  Crowd crowd(world, {walker(0, {-3, 0}, {{2, 0}, {2, 3}}, PersonEnd::Return, 1)}, {});
  for (int k = 0; k <= 150; ++k) {
    EXPECT_NEAR(crowd.covered(0), 0.1 * k, 1e-9) << k;
    crowd.decide();
    crowd.move();
  }
}

TEST(Crowd, HasCoveredItsRouteWhenItVanishes) {
  const World world = world_with({-5, -5, 5, 5}, {rectangle(-0.1, -5, 0.1, 1)}, 0.1);
  Crowd crowd(world, {walker(0, {-2, 0}, {{2, 0}}, PersonEnd::Vanish)}, {});
  for (; !crowd.states()[0].departure; crowd.move()) crowd.decide();
  // Around the end of the wall, at the radius from it, up to the tolerance of the goal.
  const double shortest = 2 * std::hypot(1.9, 1.25) + 0.2 - 0.3;
  EXPECT_GE(crowd.covered(0), shortest);
  EXPECT_LE(crowd.covered(0), 1.1 * shortest);
}

TEST(Crowd, PassesEachOtherHeadOnOnALine) {
  const World world = empty_world(6);
  for (const PeopleModel model : kModels) {
    const auto result =
        run_crowd(world, {walker(0, {-4, 0}, {{4, 0}}), walker(1, {4, 0}, {{-4, 0}})},
                  settings_of(model), 30);
    EXPECT_EQ(result.arrived, 2U);
    EXPECT_LT(result.last_arrival, 12);
  }
}

World room_with_door(double width) {
  return world_with({0, 0, 12, 8},
                    {rectangle(8, 0, 8.1, 4 - width / 2), rectangle(8, 4 + width / 2, 8.1, 8)},
                    0.05);
}

People people_in_room(int count) {
  People people;
  for (int i = 0; i < count; ++i) {
    const int column = i / 10, row = i % 10;
    people.push_back(walker(people.size(), {0.6 + column * 0.75, 0.7 + row * 0.73}, {{10.02, 4.02}},
                            PersonEnd::Vanish, 1.33));
  }
  return people;
}

/// RiMEA 4.1.1, test 12d.
TEST(Crowd, LeavesARoomFasterByAWiderDoor) {
  constexpr int kPeople = 30;
  PeopleSettings settings;
  settings.goal_tolerance = 0.8;  // so that people do not meet at the goal
  double before = std::numeric_limits<double>::infinity();
  for (const double width : {0.8, 1.0, 1.2, 1.6, 2.0}) {
    const auto result = run_crowd(room_with_door(width), people_in_room(kPeople), settings, 300);
    EXPECT_EQ(result.arrived, std::size_t{kPeople}) << width;
    EXPECT_GE(result.gap, -1e-12);
    EXPECT_GE(result.wall_gap, -1e-12);
    EXPECT_LT(result.last_arrival, before) << width;
    before = result.last_arrival;
  }
}

TEST(Crowd, DoesNotPassATooNarrowDoor) {
  for (const PeopleModel model : kModels) {
    const auto result = run_crowd(room_with_door(0.4), people_in_room(10), settings_of(model), 30);
    EXPECT_EQ(result.arrived, 0U);
    EXPECT_GE(result.gap, -1e-12);
    EXPECT_GE(result.wall_gap, -1e-12);
  }
}

TEST(Crowd, EntersNoWallAndNobody) {
  RandomEngine random(21);
  for (const PeopleModel model : kModels)
    for (int k = 0; k < 20; ++k) {
      std::vector<Polygon> polygons;
      for (int i = 0; i < 8; ++i) {
        const double x = uniform_real(random, -4, 3), y = uniform_real(random, -4, 3);
        polygons.push_back({{{x, y},
                             {x + uniform_real(random, 0.1, 1.5), y + uniform_real(random, 0, 0.3)},
                             {x, y + uniform_real(random, 0.4, 1.5)}}});
      }
      const World world = world_with({-4, -4, 4, 4}, polygons, 0.1);
      const People people = random_people(random, world, 15, PersonEnd::Return);
      const auto result = run_crowd(world, people, settings_of(model), 15);
      EXPECT_GE(result.gap, -1e-12) << to_string(model);
      EXPECT_GE(result.wall_gap, -1e-12) << to_string(model);
    }
}

TEST(Crowd, PassesAStandingPerson) {
  const World world = world_with({-2, -1, 22, 1}, {}, 0.1);
  const People people = {walker(0, {0, 0}, {{20, 0}}), walker(1, {10, 0}, {{10, 0}})};
  for (const PeopleModel model : kModels) {
    const auto result = run_crowd(world, people, settings_of(model), 60);
    EXPECT_EQ(result.arrived, 2U);
    EXPECT_GE(result.gap, -1e-12);
    EXPECT_LT(result.last_arrival, 20);
  }
}

TEST(Crowd, DoesNotNoticePeopleBehindAWall) {
  const World world = world_with({-5, -2, 5, 2}, {rectangle(-5, -0.1, 5, 0.1)}, 0.1);
  for (const PeopleModel model : kModels) {
    Crowd one(world, {walker(0, {-4, 0.5}, {{4, 0.5}})}, settings_of(model));
    Crowd two(world, {walker(0, {-4, 0.5}, {{4, 0.5}}), walker(1, {0, -0.5}, {{-4, -0.5}})},
              settings_of(model));
    for (int k = 0; k < 60; ++k) {
      for (Crowd* crowd : {&one, &two}) {
        crowd->decide();
        crowd->move();
      }
      EXPECT_EQ(one.states()[0].disc.position.x, two.states()[0].disc.position.x);
      EXPECT_EQ(one.states()[0].disc.position.y, two.states()[0].disc.position.y);
    }
  }
}

TEST(Crowd, ArrivesBesideARobotThatCoversTheGoal) {
  const World world = empty_world(6);
  for (const PeopleModel model : kModels) {
    Crowd crowd(world, {walker(0, {-4, 0}, {{0, 0}})}, settings_of(model));
    double walked = 0;
    for (int k = 0; k < 600; ++k) {
      crowd.decide(RobotDisc{{{0.1, 0}, {0, 0}, 0.3}, {true}});
      crowd.move();
      walked += crowd.states()[0].disc.velocity.norm() * 0.1;
    }
    ASSERT_TRUE(crowd.states()[0].arrival);
    EXPECT_LT(*crowd.states()[0].arrival, 10);
    EXPECT_LT(walked, 4.5);  // 3.15 m up to the place beside the robot, and around others
  }
}

TEST(Crowd, RefusesAPersonWhoStartsInAWall) {
  const World world = empty_world(5);
  EXPECT_TRUE(throws_error(ErrorKind::File, "people: person 'p100'", {"starts in a wall"}, [&] {
    Crowd(world, {walker(0, {4.8, 0}, {{0, 0}})}, {});
  }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "people: person 'p100'", {"duplicate id"}, [&] {
    Crowd(world, {walker(0, {0, 0}, {{0, 0}}), walker(0, {2, 0}, {{0, 0}})}, {});
  }));
}

/// Robots that ignore people.
enum class Robot { Slow, Fast, Erratic, Standing };

TPoint2D robot_velocity(Robot kind, const CrowdDisc& robot, int k, RandomEngine& random) {
  if (kind == Robot::Standing) return {0, 0};
  const TPoint2D offset = TPoint2D(0, 5) - robot.position;
  if (kind != Robot::Erratic)
    return offset.norm() > 0.3 ? offset * ((kind == Robot::Fast ? 2 : 1) / offset.norm())
                               : TPoint2D(0, 0);
  if (k % 10 != 0) return robot.velocity;
  const math::SinCos angle = math::sin_cos(uniform_real(random, 0, 2 * M_PI));
  return TPoint2D(angle.cos, angle.sin) * (uniform_real(random, 0, 1) < 0.3 ? 0.0 : 1.0);
}

struct Contact {
  std::size_t person = 0;
  double time = 0;  ///< s, from the update on
};

std::optional<Contact> first_contact(const Crowd& crowd, const CrowdDisc& robot,
                                     const TPoint2D& velocity, double period) {
  constexpr double kTouching = 1e-9;  // m
  std::optional<Contact> first;
  for (std::size_t i = 0; i < crowd.states().size(); ++i) {
    const PersonState& walker = crowd.states()[i];
    const auto range =
        range_within(walker.disc.position - robot.position, (walker.chosen - velocity) * period,
                     walker.disc.radius + robot.radius - kTouching);
    if (!range || range->first > 1 || range->second < 0) continue;
    const double time = std::max(0.0, range->first) * period;
    if (!first || time < first->time) first = Contact{i, time};
  }
  return first;
}

/// Whether a contact happened in the run, which it ends.
bool contact_by_robot(Robot kind, PeopleModel model, unsigned k) {
  RandomEngine random(1000 + k);
  const World world = empty_world(6, 0.5);
  CrowdDisc robot{{0, kind == Robot::Standing ? 0.0 : -5.0}, {0, 0}, 0.3};
  const People people = random_people(random, world, 12, PersonEnd::Return, {robot});
  const PeopleSettings settings = settings_of(model);
  Crowd crowd(world, people, settings);
  for (int step = 0; step < 200; ++step, crowd.move()) {
    crowd.decide(RobotDisc{robot, std::vector<bool>(people.size(), true)});
    const TPoint2D velocity = robot_velocity(kind, robot, step, random);
    if (const auto contact = first_contact(crowd, robot, velocity, settings.period)) {
      const PersonState& walker = crowd.states()[contact->person];
      const TPoint2D offset = walker.disc.position - robot.position;
      const double half = (offset.norm() - robot.radius - walker.disc.radius) / 2;
      const auto advance = [&](const TPoint2D& v) {
        return (v.x * offset.x + v.y * offset.y) / offset.norm() * contact->time;
      };
      EXPECT_LE(-advance(walker.chosen), half + 1e-9) << "the person crossed the middle";
      EXPECT_GE(advance(velocity), half - 2e-9) << "the robot did not cross the middle";
      return true;
    }
    robot.position += velocity * settings.period;
    robot.velocity = velocity;
  }
  return false;
}

TEST(Crowd, IsTouchedOnlyByARobotThatCrossesTheMiddle) {
  for (const PeopleModel model : kModels) {
    int contacts = 0;
    for (const Robot kind : {Robot::Slow, Robot::Fast, Robot::Erratic})
      for (unsigned k = 0; k < 30; ++k) contacts += contact_by_robot(kind, model, k) ? 1 : 0;
    EXPECT_GE(contacts, 15) << to_string(model);
  }
}

TEST(Crowd, DoesNotTouchAStandingRobot) {
  for (const PeopleModel model : kModels)
    for (unsigned k = 0; k < 30; ++k) EXPECT_FALSE(contact_by_robot(Robot::Standing, model, k));
}

TEST(Crowd, WalksAsAloneIfNobodyNoticesTheRobot) {
  RandomEngine random(31);
  const World world = empty_world(6);
  People people = random_people(random, world, 10, PersonEnd::Return);
  people.push_back(walker(people.size(), {0, 5}, {{0, 3}}));  // the robot crosses start and goal
  people.back().begin = 9.9;
  people.push_back(walker(people.size(), {5, -5}, {{0, -3}}));
  for (const PeopleModel model : kModels) {
    Crowd alone(world, people, settings_of(model)), with(world, people, settings_of(model));
    CrowdDisc robot{{0, -5}, {0, 1}, 0.3};
    for (int k = 0; k < 120; ++k) {
      alone.decide();
      with.decide(RobotDisc{robot, std::vector<bool>(people.size(), false)});
      alone.move();
      with.move();
      robot.position.y += 0.1;
      for (std::size_t i = 0; i < people.size(); ++i) {
        EXPECT_EQ(alone.states()[i].disc.position.x, with.states()[i].disc.position.x);
        EXPECT_EQ(alone.states()[i].disc.position.y, with.states()[i].disc.position.y);
      }
    }
  }
}

}  // namespace
}  // namespace slalom::testing
