// SPDX-License-Identifier: BSD-3-Clause
#include "free_id.h"

#include <slalom/commands/edit_people.h>
#include <slalom/core/distance.h>

#include <utility>

namespace slalom {

using mrpt::math::TPoint2D;

std::optional<StationIndex> station_at(const Scenario& scenario, const TPoint2D& point,
                                       double tolerance) {
  const People& people = scenario.people();
  for (std::size_t i = people.size(); i-- > 0;)
    if (distance_between(people[i].start, point) <= people[i].radius) return StationIndex{i, 0};
  std::optional<StationIndex> nearest;
  double smallest = tolerance;
  for (std::size_t i = 0; i < people.size(); ++i) {
    const std::vector<TPoint2D> stations = stations_of(people[i]);
    for (std::size_t k = 0; k < stations.size(); ++k) {
      const double distance = distance_between(stations[k], point);
      if (distance > smallest || (nearest && distance == smallest)) continue;
      nearest = StationIndex{i, k};
      smallest = distance;
    }
  }
  return nearest;
}

Person person_along(std::vector<TPoint2D> stations, double radius, double speed) {
  Person person;
  person.radius = radius;
  person.speed = speed;
  person.start = stations.front();
  if (stations.size() > 2 && stations.back() == stations.front()) {
    person.after = PersonEnd::Return;
    stations.pop_back();
  }
  person.route.assign(stations.begin() + (stations.size() > 1 ? 1 : 0), stations.end());
  return person;
}

Person with_station_moved(Person person, std::size_t station, double dx, double dy) {
  const bool both = stands(person);
  if (station == 0 || both) person.start += TPoint2D(dx, dy);
  if (station > 0 || both) person.route.at(both ? 0 : station - 1) += TPoint2D(dx, dy);
  return person;
}

Scenario with_people_edited(const Scenario& scenario, People people) {
  return scenario.with_people(std::move(people)).with_published_path(nullptr);
}

Scenario with_person_added(const Scenario& scenario, Person person) {
  People people = scenario.people();
  if (person.id.empty()) person.id = free_id(scenario, "person_");
  people.push_back(std::move(person));
  return with_people_edited(scenario, std::move(people));
}

Scenario with_person_replaced(const Scenario& scenario, std::size_t index, Person person) {
  People people = scenario.people();
  people.at(index) = std::move(person);
  return with_people_edited(scenario, std::move(people));
}

Scenario with_person_removed(const Scenario& scenario, std::size_t index) {
  People people = scenario.people();
  people.erase(people.begin() + static_cast<std::ptrdiff_t>(index));
  return with_people_edited(scenario, std::move(people));
}

}  // namespace slalom
