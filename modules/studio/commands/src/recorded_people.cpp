// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/commands/recorded_people.h>
#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace slalom {
namespace {

constexpr double kStandingSpeed = 1.3;  // m/s, at which who was pushed away goes back to its place

/// People that begin later wait until their place is free, which that of one who stands never is.
bool is_in(const Waypoint& at, double radius, const Person& other) {
  return ((at.t == 0 && other.begin == 0) || stands(other)) &&
         !(distance_between(at.position, other.start) >= radius + other.radius);
}

/// The positions of a mover; of one with a recording also those between them.
std::vector<Waypoint> positions_of(const Mover& mover) {
  constexpr double kStep = 0.1;      // m
  constexpr double kMaxSteps = 1e3;  // of a segment, for positions far away
  if (mover.after != MoverEnd::Vanish) return mover.waypoints;
  std::vector<Waypoint> positions = {mover.waypoints.front()};
  for (std::size_t i = 1; i < mover.waypoints.size(); ++i) {
    const Waypoint &from = mover.waypoints[i - 1], &to = mover.waypoints[i];
    const double steps =
        std::min(kMaxSteps, std::ceil(distance_between(from.position, to.position) / kStep));
    for (double step = 1; step < steps; ++step) {
      const double t = from.t + (to.t - from.t) * (step / steps);
      positions.push_back({t, mover.position(t)});
    }
    positions.push_back(to);
  }
  return positions;
}

/// The positions at which a disc has room.
std::vector<Waypoint> places_in(const World& world, const People& others, double radius,
                                std::vector<Waypoint> positions) {
  const auto has_no_room = [&](const Waypoint& at) {
    return !(world.distance_field().clearance(at.position) >= radius) ||
           std::any_of(others.begin(), others.end(),
                       [&](const Person& other) { return is_in(at, radius, other); });
  };
  positions.erase(std::remove_if(positions.begin(), positions.end(), has_no_room), positions.end());
  return positions;
}

/// The median (m/s) over time of the speeds above `least`; 0 if there are none.
double median_speed(const std::vector<Waypoint>& waypoints, double least) {
  constexpr double kSpan = 0.4;  // s, over which the noise of positions is far below a step
  std::vector<std::pair<double, double>> parts;  // speed, duration
  double total = 0;
  std::size_t from = 0;
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const double duration = waypoints[i].t - waypoints[from].t;
    if (duration < kSpan && i + 1 < waypoints.size()) continue;
    const double speed =
        distance_between(waypoints[from].position, waypoints[i].position) / duration;
    from = i;
    if (!(speed > least)) continue;
    parts.emplace_back(speed, duration);
    total += duration;
  }
  std::sort(parts.begin(), parts.end());
  double slower = 0;
  for (const auto& [speed, duration] : parts)
    if ((slower += duration) >= 0.5 * total) return speed;
  return 0;
}

double walking_speed(const std::vector<Waypoint>& waypoints) {
  constexpr double kWalking = 0.2;  // m/s, above the noise of who stands
  const double speed = median_speed(waypoints, kWalking);
  return speed > 0 ? speed : median_speed(waypoints, 0);
}

Person standing(Person person) {
  person.route = {person.start};
  person.speed = kStandingSpeed;
  return person;
}

/// A person who walks over the goals of a mover.
Person over_goals(Person person, const Mover& mover, const std::vector<Waypoint>& places) {
  for (auto goal = places.begin() + 1; goal != places.end(); ++goal)
    person.route.push_back(goal->position);
  if (mover.after == MoverEnd::Loop) {
    person.after = PersonEnd::Return;
    if (person.route.back() == person.start) person.route.pop_back();
  }
  person.speed = median_speed({mover.waypoints[0], mover.waypoints[1]}, 0);
  return person;
}

Person person_of(const Mover& mover, const std::vector<Waypoint>& places) {
  Person person;
  person.id = mover.id;
  person.radius = mover.radius;
  person.start = places.front().position;
  person.begin = places.front().t;
  const auto is_near = [&](const Waypoint& at) {
    return distance_between(at.position, person.start) <= person.radius;
  };
  if (std::all_of(places.begin(), places.end(), is_near)) return standing(person);
  if (mover.after != MoverEnd::Vanish) return over_goals(person, mover, places);
  person.route = {places.back().position};
  person.speed = walking_speed(mover.waypoints);
  person.after = PersonEnd::Vanish;
  return person;
}

}  // namespace

People recorded_people(const World& world, const Movers& movers) {
  const Scenario& scenario = world.scenario();
  People people;
  for (const Mover& mover : movers) {
    const std::vector<Waypoint> positions = positions_of(mover);
    const auto is_inside = [&](const Waypoint& at) {
      return scenario.bounds().contains(at.position);
    };
    if (std::none_of(positions.begin(), positions.end(), is_inside)) continue;
    const auto places = places_in(world, people, mover.radius, positions);
    if (places.empty())
      throw file_error(
          scenario.name() + ": person '" + mover.id + "'",
          "no position with room for its radius of " + format_number(mover.radius) + " m",
          "positions at least the radius from walls and apart from others, or a "
          "smaller radius");
    people.push_back(person_of(mover, places));
  }
  if (people.empty())
    throw file_error(scenario.name(), "nobody is in its bounds",
                     "positions in m in the world frame of the scenario");
  return people;
}

}  // namespace slalom
