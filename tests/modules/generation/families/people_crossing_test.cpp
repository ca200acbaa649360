// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "family_samples.h"

#include <slalom/core/distance.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/generation/people_crossing.h>

#include <gtest/gtest.h>

#include <set>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

const std::vector<std::string> kPeopleFamilies = {"circle_crossing", "square_crossing"};

/// Other options than the defaults, which have no ranges.
const std::string kRanges =
    "min_people = 3\nmax_people = 8\nmin_radius = 0.2\nmax_radius = 0.3\n"
    "min_speed = 0.8\nmax_speed = 1.4\n";

void expect_apart(const TPoint2D& a, const TPoint2D& b, double distance) {
  EXPECT_GE(distance_between(a, b), distance - kRoundingError);
}

TEST(PeopleCrossing, NobodyStartsOrEndsWhereAnotherOrTheRobotDoes) {
  constexpr double kGap = 0.2, kClearRadius = 0.5;  // m, the defaults
  for (const std::string& name : kPeopleFamilies) {
    const auto generator = family(name, kRanges);
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      RandomEngine engine(seed);
      const Scenario scenario = generator->generate("x", engine);
      const People& people = scenario.people();
      for (std::size_t i = 0; i < people.size(); ++i)
        for (const TPoint2D& place : {people[i].start, people[i].route.at(0)}) {
          const double radius = people[i].radius;
          expect_within(wall_clearance(scenario, place), radius + 0.05, 7);
          expect_apart(place, TPoint2D(scenario.start()), radius + kClearRadius);
          expect_apart(place, scenario.goal(), radius + kClearRadius);
          for (std::size_t j = 0; j < i; ++j) {
            expect_apart(place, people[j].start, radius + people[j].radius + kGap);
            expect_apart(place, people[j].route[0], radius + people[j].radius + kGap);
          }
        }
    }
  }
}

TEST(PeopleCrossing, NumberRadiusAndSpeedAreWithinTheirRanges) {
  for (const std::string& name : kPeopleFamilies) {
    const auto generator = family(name, kRanges);
    std::set<std::size_t> counts;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      RandomEngine engine(seed);
      const Scenario scenario = generator->generate("x", engine);
      EXPECT_TRUE(scenario.movers().empty());
      counts.insert(scenario.people().size());
      for (const Person& person : scenario.people()) {
        expect_within(person.radius, 0.2, 0.3);
        expect_within(person.speed, 0.8, 1.4);
        EXPECT_EQ(person.begin, 0);
        EXPECT_EQ(person.after, PersonEnd::Stay);
      }
    }
    EXPECT_EQ(counts, (std::set<std::size_t>{3, 4, 5, 6, 7, 8})) << name;
  }
}

TEST(PeopleCrossing, DefaultsAreThoseOfCrowdNav) {
  for (const std::string& name : kPeopleFamilies) {
    RandomEngine engine(1);
    const Scenario scenario = family(name)->generate("x", engine);
    ASSERT_EQ(scenario.people().size(), 5U);
    for (const Person& person : scenario.people()) {
      EXPECT_EQ(person.radius, 0.3);
      EXPECT_EQ(person.speed, 1);
    }
  }
}

TEST(CircleCrossing, EveryoneIsBoundForTheOppositePoint) {
  const auto generator = family("circle_crossing", "min_circle = 4\nmax_circle = 6\nnoise = 0.4\n");
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    RandomEngine engine(seed);
    const Scenario scenario = generator->generate("x", engine);
    const TPoint2D start(scenario.start()), center = (start + scenario.goal()) * 0.5;
    const double radius = distance_between(start, center);
    expect_within(radius, 4, 6);
    for (const Person& person : scenario.people()) {
      const TPoint2D opposite = center * 2.0 - person.start;
      EXPECT_LE(distance_between(person.route[0], opposite), kRoundingError);
      const double far = 0.4 * std::sqrt(2.0);
      expect_within(distance_between(person.start, center), radius - far, radius + far);
    }
  }
}

TEST(CircleCrossing, WithoutNoiseEveryoneStartsOnTheCircle) {
  RandomEngine engine(2);
  const Scenario scenario = family("circle_crossing", "noise = 0\n")->generate("x", engine);
  for (const Person& person : scenario.people())
    EXPECT_NEAR(distance_between(person.start, TPoint2D(6, 6)), 4, kRoundingError);
}

TEST(SquareCrossing, EveryoneCrossesTheLineOfTheRobot) {
  const auto generator = family("square_crossing");
  std::size_t upward = 0, people = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    RandomEngine engine(seed);
    const Scenario scenario = generator->generate("x", engine);
    EXPECT_EQ(scenario.start().y, 7);  // the middle of 10 m with margins of 2 m
    EXPECT_EQ(scenario.goal().y, 7);
    EXPECT_NEAR(scenario.start().x + scenario.goal().x, 14, kRoundingError);
    expect_within(scenario.goal().x - scenario.start().x, 8, 10);
    for (const Person& person : scenario.people()) {
      const TPoint2D& goal = person.route[0];
      EXPECT_LE((person.start.y - 7) * (goal.y - 7), 0);
      for (const TPoint2D& place : {person.start, goal})
        expect_within(std::max(std::abs(place.x - 7), std::abs(place.y - 7)), 0, 5);
      upward += goal.y > 7 ? 1 : 0;
      ++people;
    }
  }
  // Four standard deviations of fair coins.
  EXPECT_NEAR(static_cast<double>(upward), static_cast<double>(people) / 2,
              2 * std::sqrt(static_cast<double>(people)));
}

TEST(PeopleCrossing, TheGreatestNumberOfPeopleHasRoom) {
  // Places of 0.8 m: 0.72 * 2 pi 4 / 0.8 / 2 - 1 = 10.3 on the circle, (10 / 0.8)^2 / 4 = 39.1.
  for (const auto& [name, most] : {std::pair("circle_crossing", 10), {"square_crossing", 39}}) {
    const std::string number = std::to_string(most), more = std::to_string(most + 1);
    const auto generator = family(name, "min_people = " + number + "\nmax_people = " + number +
                                            (most == 10 ? "\nnoise = 0\n" : "\n"));
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      RandomEngine engine(seed);
      EXPECT_EQ(generator->generate("x", engine).people().size(), static_cast<std::size_t>(most));
    }
    EXPECT_NE(
        refusal(name, "max_people = " + more + "\n")
            .find("max_people: have no room where they start and end; expected at most " + number),
        std::string::npos)
        << refusal(name, "max_people = " + more + "\n");
  }
}

TEST(PeopleCrossing, WithoutRoomBesideTheRobotAreAnErrorThatNamesTheScenario) {
  const auto generator = family("circle_crossing", "clear_radius = 9\n");
  EXPECT_TRUE(throws_error(ErrorKind::Job, "x: no room for the starts and goals of 5 people",
                           {"fewer or smaller people"}, [&] {
                             RandomEngine engine(1);
                             generator->generate("x", engine);
                           }));
}

TEST(PeopleCrossing, PeopleOfTheCampaignAreAddedToThoseOfTheFamily) {
  MixSettings settings;
  settings.each.count = 1;
  settings.people.count = 2;
  const auto progress = make_silent_progress();
  People people;
  generate_mix({{family("square_crossing"), 1, 5, "c"}}, settings, *progress,
               [&](std::vector<GeneratedScenario>& batch) {
                 people = batch.at(0).scenario.people();
                 return std::vector<std::size_t>();
               });
  ASSERT_EQ(people.size(), 7U);
  EXPECT_EQ(people[4].after, PersonEnd::Stay);
  EXPECT_EQ(people[5].id, "person_5");
  EXPECT_EQ(people[5].after, PersonEnd::Return);
}

TEST(PeopleCrossing, RejectInvalidOptions) {
  for (const std::string& name : kPeopleFamilies)
    expect_refusals(name, {{"max_people = 4\n", "max_people: is less than min_people"},
                           {"max_radius = 0.2\n", "max_radius: is less than min_radius"},
                           {"max_speed = 0.5\n", "max_speed: is less than min_speed"},
                           {"margin = 0.3\n", "margin: people would touch the border"},
                           {"gap = -1\n", "gap"}});
  expect_refusals("circle_crossing", {{"max_circle = 3\n", "max_circle: is less than min_circle"},
                                      {"noise = 1.7\n", "margin: people would touch the border"}});
}

}  // namespace
}  // namespace slalom
