// SPDX-License-Identifier: BSD-3-Clause
#include "content_checks.h"

#include <slalom/core/distance.h>
#include <slalom/core/hash.h>
#include <slalom/scenario/person.h>

#include <algorithm>
#include <cstdint>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

void check_person(const std::string& where, const Person& person) {
  check_radius(where, person.radius);
  if (!(person.speed > 0) || !(person.speed <= kMaxSpeed))
    throw file_error(where, "invalid speed " + format_number(person.speed) + " m/s",
                     "a speed above 0, at most " + format_number(kMaxSpeed));
  if (!in_range(person.begin) || person.begin < 0)
    throw file_error(where, "invalid begin " + format_number(person.begin) + " s",
                     "a time from 0 to " + format_number(kMaxNumber));
  if (!in_range(person.start))
    throw file_error(where, "the start is out of range",
                     "a position within +-" + format_number(kMaxNumber));
  if (person.route.empty()) throw file_error(where, "no route", "at least the goal");
  for (std::size_t i = 0; i < person.route.size(); ++i)
    if (!in_range(person.route[i]))
      throw file_error(where, "point " + std::to_string(i) + " of the route is out of range",
                       "a position within +-" + format_number(kMaxNumber));
}

bool same_point(const TPoint2D& a, const TPoint2D& b) {
  return a.x == b.x && a.y == b.y;
}

/// Only of those that are there from the beginning: others wait until their place is free.
void check_starts(const std::string& name, const People& people) {
  for (std::size_t i = 0; i < people.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Person &a = people[j], &b = people[i];
      if (a.begin == 0 && b.begin == 0 &&
          !(distance_between(a.start, b.start) >= a.radius + b.radius))
        throw file_error(name + ": person '" + b.id + "'", "starts within person '" + a.id + "'",
                         "starts at least the sum of the radii apart");
    }
}

}  // namespace

bool Person::operator==(const Person& other) const {
  return id == other.id && radius == other.radius && speed == other.speed && begin == other.begin &&
         after == other.after && same_point(start, other.start) &&
         std::equal(route.begin(), route.end(), other.route.begin(), other.route.end(), same_point);
}

void check_people(const std::string& name, const People& people) {
  constexpr std::size_t kMaxPeople = 10000;
  if (people.size() > kMaxPeople)
    throw file_error(name, std::to_string(people.size()) + " people",
                     "at most " + std::to_string(kMaxPeople));
  std::set<std::string> ids;
  for (std::size_t i = 0; i < people.size(); ++i)
    check_person(checked_element(name, "person", i, people[i].id, ids), people[i]);
  check_starts(name, people);
}

std::vector<TPoint2D> stations_of(const Person& person) {
  std::vector<TPoint2D> stations = {person.start};
  stations.insert(stations.end(), person.route.begin(), person.route.end());
  return stations;
}

bool stands(const Person& person) {
  return person.route.size() == 1 && person.route[0] == person.start;
}

void add_content(Hasher& hasher, const People& people) {
  hasher.add("people").add(static_cast<std::uint64_t>(people.size()));
  for (const Person& person : people) {
    hasher.add(person.id).add(person.radius).add(person.speed).add(person.begin);
    hasher.add(to_string(person.after)).add(person.start.x).add(person.start.y);
    hasher.add(static_cast<std::uint64_t>(person.route.size()));
    for (const TPoint2D& point : person.route) hasher.add(point.x).add(point.y);
  }
}

}  // namespace slalom
