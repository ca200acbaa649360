// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// Edits of the people of one scenario, like those of its movers (edit_movers.h). All with_...()
/// throw as check_people() of a name does; those with an index require one of a person. Lengths in
/// m, world frame.

/// A point of a person's way: station 0 is its start, the others are the points of its route.
struct StationIndex {
  std::size_t person = 0, station = 0;
};
/// The start of the last person whose disc there contains the point; otherwise the nearest station
/// of all people within `tolerance`; none otherwise.
std::optional<StationIndex> station_at(const Scenario& scenario, const mrpt::math::TPoint2D& point,
                                       double tolerance);

/// A person without an id who walks over one or more points, the first of which is the start, at
/// `speed` (m/s), from time 0 on. With one point it stands there; if the last point is the first,
/// the person walks to and fro.
Person person_along(std::vector<mrpt::math::TPoint2D> stations, double radius, double speed);
/// The person with one station translated; who stands, with its start and goal.
Person with_station_moved(Person person, std::size_t station, double dx, double dy);

/// Adds a person; one without an id gets "person_1" or the next number that is free.
Scenario with_person_added(const Scenario& scenario, Person person);
Scenario with_person_replaced(const Scenario& scenario, std::size_t index, Person person);
Scenario with_person_removed(const Scenario& scenario, std::size_t index);
/// Replaces all people.
Scenario with_people_edited(const Scenario& scenario, People people);

}  // namespace slalom
