// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/hash.h>
#include <slalom/scenario/convert.h>
#include <slalom/scenario/person.h>
#include <slalom/scenario/scenario.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <set>

namespace slalom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

People two_people() {
  return {{"anna", 0.25, 1.3, {1, 2}, {{5, 2}, {5, 6}}, 0, PersonEnd::Stay},
          {"ben", 0.3, 1.1, {2, 2}, {{1, 1}}, 0, PersonEnd::Return}};
}

std::string hash_of(const People& people) {
  Hasher hasher;
  add_content(hasher, people);
  return hasher.hex();
}

const std::vector<std::function<void(Person&)>> kChanges = {
    [](Person& p) { p.id = "other"; },
    [](Person& p) { p.radius = 0.26; },
    [](Person& p) { p.speed = 1.2; },
    [](Person& p) { p.start.x = 0; },
    [](Person& p) { p.start.y = 0; },
    [](Person& p) { p.route.pop_back(); },
    [](Person& p) { p.route[0].y = 3; },
    [](Person& p) { p.begin = 1; },
    [](Person& p) { p.after = PersonEnd::Vanish; }};

TEST(Person, HasAHashOfAllThatItIs) {
  std::set<std::string> hashes = {hash_of({}), hash_of(two_people())};
  for (const auto& change : kChanges) {
    People people = two_people();
    change(people[0]);
    EXPECT_NE(people[0], two_people()[0]);
    hashes.insert(hash_of(people));
  }
  EXPECT_EQ(hashes.size(), kChanges.size() + 2);
  EXPECT_EQ(two_people(), two_people());
}

TEST(Person, IsRefusedWithItsIdWhenInvalid) {
  EXPECT_NO_THROW(check_people("walk", two_people()));
  const auto refused = [](const std::function<void(Person&)>& change, const std::string& what) {
    People people = two_people();
    change(people[0]);
    return throws_error(ErrorKind::File, "walk: person ", {what},
                        [&] { check_people("walk", people); });
  };
  EXPECT_TRUE(refused([](Person& p) { p.id = "ben"; }, "'ben': duplicate id"));
  EXPECT_TRUE(refused([](Person& p) { p.id = ""; }, "0: invalid id"));
  EXPECT_TRUE(refused([](Person& p) { p.id = "caf\xe9"; }, "0: invalid id"));
  EXPECT_TRUE(refused([](Person& p) { p.radius = 0; }, "'anna': invalid radius 0 m"));
  EXPECT_TRUE(refused([](Person& p) { p.radius = kInfinity; }, "invalid radius"));
  EXPECT_TRUE(refused([](Person& p) { p.speed = 0; }, "invalid speed 0 m/s"));
  EXPECT_TRUE(refused([](Person& p) { p.speed = 1001; }, "invalid speed 1001 m/s"));
  EXPECT_TRUE(refused([](Person& p) { p.speed = std::nan(""); }, "invalid speed"));
  EXPECT_TRUE(refused([](Person& p) { p.begin = -1; }, "invalid begin -1 s"));
  EXPECT_TRUE(refused([](Person& p) { p.begin = std::nan(""); }, "invalid begin"));
  EXPECT_TRUE(refused([](Person& p) { p.start.y = kInfinity; }, "the start is out of range"));
  EXPECT_TRUE(refused([](Person& p) { p.route.clear(); }, "no route"));
  EXPECT_TRUE(refused([](Person& p) { p.route[1].x = 2e6; }, "point 1 of the route is out"));
  EXPECT_TRUE(refused(
      [](Person& p) {
        p.start = {1.46, 2};
      },
      "'ben': starts within person 'anna'"));
}

TEST(Person, MayWaitUntilItsPlaceIsFree) {
  People people = two_people();
  people[1].start = people[0].start;
  people[1].begin = 0.1;
  EXPECT_NO_THROW(check_people("walk", people));
}

TEST(Person, IsOneOfTenThousandAtMost) {
  People people(10001, two_people()[0]);
  EXPECT_TRUE(throws_error(ErrorKind::File, "walk: 10001 people", {"at most 10000"},
                           [&] { check_people("walk", people); }));
}

Scenario room() {
  return Scenario::continuous("room", {0, 0, 10, 10}, {{{{5, 5}, 1}}, {}}, {1, 9, 0}, {9, 9});
}

TEST(Person, IsPartOfItsScenarioAndOfItsHash) {
  EXPECT_EQ(room().with_people({}).hash(), room().hash());
  const Scenario walked = room().with_people(two_people());
  EXPECT_EQ(walked.people(), two_people());
  EXPECT_EQ(walked.with_people({}).hash(), room().hash());
  std::set<std::string> hashes = {room().hash(), walked.hash(), walked.with_goal_heading(1).hash()};
  for (const auto& change : kChanges) {
    People people = two_people();
    change(people[0]);
    hashes.insert(room().with_people(people).hash());
  }
  EXPECT_EQ(hashes.size(), kChanges.size() + 3);
}

TEST(Person, StaysWhenAnythingElseOfTheScenarioChanges) {
  const Scenario walked = room().with_people(two_people());
  const Mover mover{"m", 0.2, {{0, {8, 1}}}};
  EXPECT_EQ(walked.renamed("other").people(), two_people());
  EXPECT_EQ(walked.with_start_goal({1, 9, 1}, {8, 9}).people(), two_people());
  EXPECT_EQ(walked.with_goal_heading(1).with_movers({mover}).people(), two_people());
  EXPECT_EQ(room().with_rest_of(walked).hash(), walked.hash());
  for (const Representation to : {Representation::Grid, Representation::Points})
    EXPECT_EQ(convert(walked, to, ConversionOptions()).people(), two_people());
}

TEST(Person, IsRefusedByAScenarioThatItLeavesOrWhoseMoverHasItsId) {
  const auto refused = [](const Scenario& scenario, const std::function<void(Person&)>& change,
                          const std::string& what) {
    People people = two_people();
    change(people[0]);
    return throws_error(ErrorKind::File, "room: person 'anna'", {what},
                        [&] { (void)scenario.with_people(people); });
  };
  EXPECT_TRUE(refused(
      room(), [](Person& p) { p.start.x = -1; }, "start at (-1, 2)"));
  EXPECT_TRUE(refused(
      room(), [](Person& p) { p.route[1].y = 11; }, "point 1 of the route"));
  const Mover anna{"anna", 0.2, {{0, {8, 1}}}};
  EXPECT_TRUE(refused(
      room().with_movers({anna}), [](Person&) {}, "id of a moving obstacle"));
}

}  // namespace
}  // namespace slalom
