// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/enum_names.h>

#include <mrpt/math/TPoint2D.h>

#include <array>
#include <string>
#include <vector>

namespace slalom {

class Hasher;

/// Behavior of a person at its goal.
enum class PersonEnd { Stay, Vanish, Return };
constexpr auto enum_names(PersonEnd) {
  return std::array{"stay", "vanish", "return"};
}

/// A person: a closed disc that walks to a goal and reacts to others. Its motion depends on them,
/// unlike that of a Mover.
struct Person {
  std::string id;
  double radius = 0;                        ///< m
  double speed = 0;                         ///< m/s, the preferred one
  mrpt::math::TPoint2D start;               ///< m, world frame
  std::vector<mrpt::math::TPoint2D> route;  ///< m, via points in their order, then the goal
  /// s, the earliest time of its presence. It appears at the first update from then on at which its
  /// place is free.
  double begin = 0;
  /// Stay: it remains at its goal, and goes back there if it was pushed away. Vanish: it is absent
  /// from its arrival on. Return: it walks to and fro between start and goal, by its via points.
  PersonEnd after = PersonEnd::Stay;

  bool operator==(const Person& other) const;
  bool operator!=(const Person& other) const { return !(*this == other); }
};

using People = std::vector<Person>;

/// Start and route.
std::vector<mrpt::math::TPoint2D> stations_of(const Person& person);
/// Whether its start is its goal, so that it stands there.
bool stands(const Person& person);

/// Throws Error (File) naming `name` and the person when there are more than 10000, an id is empty,
/// too long (100 bytes), not UTF-8 or used twice, a radius or speed is not above 0, a route has no
/// point, a number is not finite or exceeds a million, a speed exceeds 1000 m/s, a time is
/// negative, or two people that are there from the beginning overlap.
void check_people(const std::string& name, const People& people);

void add_content(Hasher& hasher, const People& people);

}  // namespace slalom
