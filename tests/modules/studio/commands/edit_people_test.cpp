// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/commands/edit_people.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// A person from (2, 2) over (4, 2) to (4, 4), and one who stands at (8, 3).
Scenario peopled_room() {
  const People people = {{"a", 0.5, 1.2, {2, 2}, {{4, 2}, {4, 4}}},
                         {"person_1", 0.3, 1, {8, 3}, {{8, 3}}}};
  return Scenario::continuous("room", {0, 0, 10, 6}, {}, {1, 5, 0}, {9, 5}).with_people(people);
}

TEST(EditPeople, FindsStationsAndTheDiscAtTheStart) {
  const auto found = [](const TPoint2D& at) {
    const auto index = station_at(peopled_room(), at, 0.2);
    return index ? std::to_string(index->person) + "." + std::to_string(index->station) : "none";
  };
  EXPECT_EQ(found({2.4, 2}), "0.0");
  EXPECT_EQ(found({2.6, 2}), "none") << "0.6 m from the start";
  EXPECT_EQ(found({4.1, 2}), "0.1");
  EXPECT_EQ(found({4, 4.15}), "0.2");
  EXPECT_EQ(found({8, 3.2}), "1.0");
}

TEST(EditPeople, WalkOverTheStations) {
  const Person walks = person_along({{1, 1}, {4, 1}, {4, 5}}, 0.2, 0.5);
  EXPECT_EQ(walks, (Person{"", 0.2, 0.5, {1, 1}, {{4, 1}, {4, 5}}}));
  EXPECT_EQ(walks.after, PersonEnd::Stay);
  EXPECT_EQ(person_along({{1, 1}}, 0.2, 0.5).route, (std::vector<TPoint2D>{{1, 1}}));
  const Person to_and_fro = person_along({{1, 1}, {4, 1}, {1, 1}}, 0.2, 0.5);
  EXPECT_EQ(to_and_fro.after, PersonEnd::Return);
  EXPECT_EQ(to_and_fro.route, (std::vector<TPoint2D>{{4, 1}}));
}

TEST(EditPeople, MovesStations) {
  const Person a = peopled_room().people()[0], still = peopled_room().people()[1];
  EXPECT_EQ(stations_of(with_station_moved(a, 0, 1, -1)),
            (std::vector<TPoint2D>{{3, 1}, {4, 2}, {4, 4}}));
  EXPECT_EQ(stations_of(with_station_moved(a, 2, 1, -1)),
            (std::vector<TPoint2D>{{2, 2}, {4, 2}, {5, 3}}));
  for (const std::size_t station : {0, 1})
    EXPECT_EQ(stations_of(with_station_moved(still, station, 1, 1)),
              (std::vector<TPoint2D>{{9, 4}, {9, 4}}))
        << "who stands goes on standing";
}

TEST(EditPeople, AddsReplacesAndRemoves) {
  const Scenario room = peopled_room();
  const Scenario more = with_person_added(room, person_along({{3, 5}, {5, 5}}, 0.2, 1));
  ASSERT_EQ(more.people().size(), 3U);
  EXPECT_EQ(more.people()[2].id, "person_2") << "person_1 is taken";
  EXPECT_NE(more.hash(), room.hash());
  EXPECT_EQ(with_person_removed(more, 2).hash(), room.hash());
  Person faster = room.people()[0];
  faster.speed = 2;
  EXPECT_EQ(with_person_replaced(room, 0, faster).people()[0], faster);
  const Scenario with_mover = room.with_movers({{"person_2", 0.2, {{0, {5, 5}}}}});
  EXPECT_EQ(with_person_added(with_mover, person_along({{3, 5}}, 0.2, 1)).people()[2].id,
            "person_3")
      << "movers have ids, too";
}

TEST(EditPeople, RefusesStartsInOthersAndOutside) {
  const auto refuses = [](const TPoint2D& start, const std::string& text) {
    return throws_error(ErrorKind::File, "room: person 'person_2'", {text}, [&] {
      with_person_added(peopled_room(), person_along({start, {5, 5}}, 0.2, 1));
    });
  };
  EXPECT_TRUE(refuses({2.6, 2}, "starts within person 'a'"));
  EXPECT_TRUE(refuses({-1, 2}, "start"));
}

}  // namespace
}  // namespace slalom
