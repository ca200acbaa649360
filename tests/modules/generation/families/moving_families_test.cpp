// SPDX-License-Identifier: BSD-3-Clause
#include "family_samples.h"

#include <slalom/core/distance.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/generation/start_goal.h>
#include <slalom/scenario/geometry.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The families in which something moves.
const std::vector<std::string> kMovingFamilies = {"circle", "crossing", "doorway", "oncoming",
                                                  "overtaking"};

RC_GTEST_PROP(MovingFamilies, MoversKeepOffWallsAtAllTimesAndOffTheStartAtFirst, ()) {
  const std::string name = *rc::gen::elementOf(kMovingFamilies);
  RandomEngine engine(static_cast<std::uint64_t>(*rc::gen::inRange(1, 1'000'000)));
  const Scenario scenario = family(name)->generate("x", engine);
  // A start right before the door leaves movers no way.
  RC_ASSERT(name == "doorway" || !scenario.movers().empty());
  const TPoint2D start(scenario.start().x, scenario.start().y);
  for (const Mover& mover : scenario.movers()) {
    RC_ASSERT(mover.present(0));
    RC_ASSERT(distance_between(mover.position(0), start) >= mover.radius + 0.5);
    for (double t = 0; t < 1.5 * mover.waypoints.back().t; t += 0.043)
      RC_ASSERT(!mover.present(t) || wall_clearance(scenario, mover.position(t)) >= mover.radius);
  }
}

RC_GTEST_PROP(MovingFamilies, NumberRadiusAndSpeedAreWithinTheirRanges, ()) {
  const std::string name = *rc::gen::elementOf(kMovingFamilies);
  RandomEngine engine(static_cast<std::uint64_t>(*rc::gen::inRange(1, 1'000'000)));
  const Scenario scenario =
      family(name,
             "min_movers = 2\nmax_movers = 4\nmin_radius = 0.25\nmax_radius = 0.3\n"
             "min_speed = 0.6\nmax_speed = 0.7\n")
          ->generate("x", engine);
  RC_ASSERT(scenario.movers().size() <= 4U);
  RC_ASSERT(name == "doorway" || scenario.movers().size() >= 2U);
  for (const Mover& mover : scenario.movers()) {
    RC_ASSERT(mover.radius >= 0.25 && mover.radius <= 0.3);
    for (std::size_t i = 1; i < mover.waypoints.size(); ++i) {
      const Waypoint &a = mover.waypoints[i - 1], &b = mover.waypoints[i];
      const double speed = distance_between(a.position, b.position) / (b.t - a.t);
      const bool waits = a.position == b.position;
      RC_ASSERT(waits || (speed > 0.6 - 1e-9 && speed < 0.7 + 1e-9));
    }
  }
}

TEST(Circle, EveryoneIsBoundForTheOppositePoint) {
  RandomEngine engine(3);
  const Scenario scenario = family("circle", "max_shift_deg = 0\nmin_movers = 3\nmax_movers = 3\n")
                                ->generate("x", engine);
  const TPoint2D start(scenario.start().x, scenario.start().y);
  const TPoint2D center = (start + scenario.goal()) * 0.5;
  const double radius = distance_between(start, center);
  ASSERT_EQ(scenario.movers().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& walk = scenario.movers()[i].waypoints;
    const TPoint2D from = walk.front().position - center, to = walk.back().position - center;
    EXPECT_NEAR(std::hypot(from.x, from.y), radius, 1e-9);
    EXPECT_NEAR(std::hypot(from.x + to.x, from.y + to.y), 0, 1e-9);
    // Four on the circle: a quarter turn from one to the next.
    const TPoint2D robot = start - center;
    const double turn =
        std::atan2(robot.x * from.y - robot.y * from.x, robot.x * from.x + robot.y * from.y);
    EXPECT_NEAR(wrap_angle(turn - M_PI / 2 * static_cast<double>(i + 1)), 0, 1e-9);
    const double speed = 2 * radius / walk.back().t;
    EXPECT_GT(speed, 0.4 - 1e-9);
    EXPECT_LT(speed, 1.2 + 1e-9);
  }
}

TEST(CorridorFlow, MoversComeTowardTheRobotOrGoAheadOfIt) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomEngine engine(seed), other(seed);
    const Scenario oncoming = family("oncoming")->generate("x", engine);
    for (const Mover& mover : oncoming.movers()) {
      EXPECT_GT(mover.position(0).x, oncoming.start().x + 1);
      EXPECT_LT(mover.velocity(0).x, 0);
      EXPECT_EQ(mover.after, MoverEnd::Vanish);
      EXPECT_LT(mover.waypoints.back().position.x, oncoming.start().x);
    }
    const Scenario overtaking = family("overtaking")->generate("x", other);
    for (const Mover& mover : overtaking.movers()) {
      EXPECT_GT(mover.velocity(0).x, 0);
      EXPECT_LE(std::hypot(mover.velocity(0).x, mover.velocity(0).y), 0.4 + 1e-9);
    }
  }
}

TEST(Crossing, EveryWayCrossesThatOfTheRobot) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    RandomEngine engine(seed);
    const Scenario scenario = family("crossing")->generate("x", engine);
    const TPoint2D start(scenario.start().x, scenario.start().y);
    const TPoint2D way = scenario.goal() - start;
    const auto side = [&](const TPoint2D& p) {
      return way.x * (p.y - start.y) - way.y * (p.x - start.x);
    };
    for (const Mover& mover : scenario.movers()) {
      EXPECT_EQ(mover.after, MoverEnd::Loop);
      EXPECT_LE(side(mover.waypoints[1].position) * side(mover.waypoints[2].position), 0);
    }
  }
}

TEST(Doorway, EveryMoverGoesThroughTheDoor) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomEngine engine(seed);
    const Scenario scenario = family("doorway")->generate("x", engine);
    for (const Mover& mover : scenario.movers()) {
      EXPECT_GT(mover.position(0).x, 6);
      EXPECT_LT(mover.position(1000).x, 6);
      EXPECT_TRUE(mover.present(1000));
      EXPECT_LE(mover.waypoints[1].t, 15);
    }
  }
}

TEST(MovingFamilies, WalkersAreAddedToTheMoversOfTheFamily) {
  MixSettings settings;
  settings.each.count = 1;
  settings.walkers.count = 2;
  const auto progress = make_silent_progress();
  std::set<std::string> ids;
  generate_mix({{family("crossing", "min_movers = 3\nmax_movers = 3\n"), 1, 5, "c"}}, settings,
               *progress, [&](std::vector<GeneratedScenario>& batch) {
                 for (const Mover& mover : batch.at(0).scenario.movers()) ids.insert(mover.id);
                 return std::vector<std::size_t>();
               });
  EXPECT_EQ(ids, (std::set<std::string>{"mover_0", "mover_1", "mover_2", "walker_0", "walker_1"}));
}

/// The families whose moving obstacles may be people.
const std::vector<std::string> kFamiliesWithPeople = {"crossing", "doorway", "oncoming",
                                                      "overtaking"};

TEST(MovingFamilies, WithoutPeopleTheOptionChangesNothing) {
  for (const std::string& name : kFamiliesWithPeople) {
    RandomEngine engine(3), same(3);
    const Scenario scenario = family(name)->generate("x", engine);
    EXPECT_TRUE(scenario.people().empty());
    EXPECT_EQ(scenario.hash(), family(name, "people = false\n")->generate("x", same).hash());
  }
}

/// Equal seeds give equal numbers for as long as nobody has to be drawn again.
TEST(MovingFamilies, APersonStartsEndsAndMovesAsAMoverDoes) {
  for (const std::string& name : kFamiliesWithPeople) {
    const std::string one = "min_movers = 1\nmax_movers = 1\n";
    const auto movers = family(name, one), people = family(name, one + "people = true\n");
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      RandomEngine engine(seed), same(seed);
      const Scenario scripted = movers->generate("x", engine);
      const Scenario reacting = people->generate("x", same);
      EXPECT_EQ(scripted.with_movers({}).hash(), reacting.with_people({}).hash());
      ASSERT_EQ(reacting.people().size(), scripted.movers().size());
      if (reacting.people().empty()) continue;
      const Mover& mover = scripted.movers()[0];
      const Person& person = reacting.people()[0];
      const auto& walk = mover.waypoints;
      EXPECT_EQ(person.id, "person_0");
      EXPECT_EQ(person.radius, mover.radius);
      EXPECT_EQ(person.start, walk.front().position);
      EXPECT_EQ(person.begin, 0);
      const TPoint2D v = mover.velocity(walk.back().t - 1e-3);
      EXPECT_NEAR(person.speed, std::hypot(v.x, v.y), kRoundingError);
      if (name == "crossing") {
        EXPECT_EQ(person.after, PersonEnd::Return);
        EXPECT_EQ(person.route, (std::vector<TPoint2D>{walk[1].position, walk[2].position}));
      } else {
        EXPECT_EQ(person.after, name == "doorway" ? PersonEnd::Stay : PersonEnd::Vanish);
        EXPECT_EQ(person.route, std::vector<TPoint2D>{walk.back().position});
      }
    }
  }
}

TEST(MovingFamilies, PeopleStartAndStayApartAndOffTheRobot) {
  for (const std::string& name : kFamiliesWithPeople) {
    const auto generator = family(name, "min_movers = 4\nmax_movers = 8\npeople = true\n");
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      RandomEngine engine(seed);
      const Scenario scenario = generator->generate("x", engine);
      EXPECT_TRUE(scenario.movers().empty());
      const People& people = scenario.people();
      for (std::size_t i = 0; i < people.size(); ++i) {
        const Person& a = people[i];
        EXPECT_GE(wall_clearance(scenario, a.start), a.radius + 0.05 - kRoundingError);
        EXPECT_GE(distance_between(a.start, TPoint2D(scenario.start())), a.radius + 0.5);
        for (std::size_t j = 0; j < i; ++j) {
          const Person& b = people[j];
          const double apart = a.radius + b.radius + 0.05;
          EXPECT_GE(distance_between(a.start, b.start), apart);
          if (a.after != PersonEnd::Vanish) {
            EXPECT_GE(distance_between(a.route.back(), b.route.back()), apart);
          }
        }
      }
    }
  }
}

TEST(MovingFamilies, NobodyStartsInCellsOfWalls) {
  // Cells of 0.3 m, which may reach farther from a wall than the 0.05 m that people keep from it.
  MixSettings settings;
  settings.each.count = 40;
  settings.each.resolution = 0.3;
  const auto progress = make_silent_progress();
  std::size_t people = 0;
  generate_mix({{family("doorway", "people = true\n"), 1, 5, "d"}}, settings, *progress,
               [&](std::vector<GeneratedScenario>& batch) {
                 for (const GeneratedScenario& one : batch) {
                   const World world(one.scenario, settings.each.resolution);
                   for (const Person& person : one.scenario.people()) {
                     EXPECT_GE(world.distance_field().clearance(person.start), person.radius);
                     ++people;
                   }
                 }
                 return std::vector<std::size_t>();
               });
  EXPECT_GT(people, 40U);
}

TEST(MovingFamilies, WithoutMoversAcceptWallsAtAnyDistance) {
  const std::string none = "min_movers = 0\nmax_movers = 0\n";
  EXPECT_EQ(refusal("doorway", none + "min_door = 0.3\nmax_door = 0.3\n"), "no error");
  EXPECT_EQ(refusal("oncoming", none + "max_radius = 1\n"), "no error");
}

TEST(MovingFamilies, RejectInvalidOptions) {
  EXPECT_NE(refusal("crossing", "max_movers = 2\n").find("max_movers: is less than min_movers"),
            std::string::npos);
  EXPECT_NE(
      refusal("oncoming", "max_radius = 1\n").find("moving obstacles do not fit between the walls"),
      std::string::npos);
  EXPECT_NE(refusal("circle", "max_movers = 100\n").find("within clear_radius of the start"),
            std::string::npos);
  EXPECT_NE(refusal("doorway", "max_door = 9\n").find("max_door: is higher than the rooms"),
            std::string::npos);
}

}  // namespace
}  // namespace slalom
