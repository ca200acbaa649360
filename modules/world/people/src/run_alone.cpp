// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/people/run_alone.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

bool same_place(const Waypoint& a, const Waypoint& b) {
  return a.position.x == b.position.x && a.position.y == b.position.y;
}

/// Whether `people[i]` starts apart from the others, and from walls as `start` does.
bool has_room(const World& world, const People& people, std::size_t i, const TPoint2D& start) {
  const Person& person = people[i];
  const DistanceField& walls = world.distance_field();
  if (walls.clearance(person.start) < std::min(person.radius, walls.clearance(start))) return false;
  return std::all_of(people.begin(), people.end(), [&](const Person& other) {
    return &other == &person || other.begin > 0 || person.begin > 0 ||
           distance_between(person.start, other.start) >= person.radius + other.radius;
  });
}

/// The value 1e-12 (m) beside, or the next one.
double beside(double value, int sign) {
  constexpr double kShift = 1e-12;
  const double moved = value + sign * kShift;
  return moved != value ? moved : std::nextafter(value, sign * HUGE_VAL);
}

/// The people of the world, of whom the first one with room does not start exactly at its start.
People shifted(const World& world) {
  People people = world.scenario().people();
  for (std::size_t i = 0; i < people.size(); ++i) {
    TPoint2D& start = people[i].start;
    const TPoint2D before = start;
    for (const TPoint2D& moved :
         {TPoint2D(beside(start.x, 1), start.y), TPoint2D(beside(start.x, -1), start.y),
          TPoint2D(start.x, beside(start.y, 1)), TPoint2D(start.x, beside(start.y, -1))}) {
      start = moved;
      if (has_room(world, people, i, before)) return people;
    }
    start = before;
  }
  return people;
}

}  // namespace

CrowdRecord::CrowdRecord(const People& people, double horizon, Movers others)
    : first_(others.size()), movers_(std::move(others)) {
  for (const Person& person : people)
    movers_.push_back({person.id, person.radius, {{horizon + 1, person.start}}});
}

void CrowdRecord::add(const Crowd& crowd) {
  for (std::size_t i = 0; i < crowd.states().size(); ++i) {
    const PersonState& state = crowd.states()[i];
    const bool vanishes = state.departure && *state.departure == crowd.time();
    if (!state.is_present && !vanishes) continue;
    Mover& mover = movers_[first_ + i];
    std::vector<Waypoint>& waypoints = mover.waypoints;
    const Waypoint here{crowd.time(), state.disc.position};
    // The one of who had not appeared, or of the last motion.
    if (!waypoints.empty() && waypoints.back().t >= here.t) waypoints.pop_back();
    const std::size_t n = waypoints.size();
    if (n > 1 && same_place(waypoints[n - 1], here) && same_place(waypoints[n - 2], here))
      waypoints.pop_back();
    waypoints.push_back(here);
    if (vanishes) mover.after = MoverEnd::Vanish;
  }
}

Arrivals arrivals_in(const Crowd& crowd, double until) {
  Arrivals arrivals;
  for (const PersonState& state : crowd.states())
    arrivals.push_back(state.arrival && *state.arrival <= until ? state.arrival : std::nullopt);
  return arrivals;
}

PeopleAlone::PeopleAlone(const World& world, const PeopleSettings& settings)
    : world_(world),
      settings_(settings),
      start_(world, world.scenario().people(), settings),
      now_(start_) {}

Arrivals PeopleAlone::arrivals(double until) {
  covered(static_cast<int>(std::ceil(until / settings_.period)) + 1);
  return arrivals_in(now_, until);
}

Arrivals PeopleAlone::arrivals_beside(double until) {
  if (!beside_) beside_.emplace(world_, shifted(world_), settings_);
  for (; beside_->time() <= until; beside_->move()) beside_->decide();
  return arrivals_in(*beside_, until);
}

const std::vector<double>& PeopleAlone::covered(int updates) {
  for (;; now_.decide(), now_.move()) {
    if (static_cast<std::size_t>(now_.updates()) == covered_.size()) {
      std::vector<double>& covered = covered_.emplace_back();
      for (std::size_t i = 0; i < now_.states().size(); ++i) covered.push_back(now_.covered(i));
    }
    if (now_.updates() >= updates) return covered_.at(static_cast<std::size_t>(updates));
  }
}

Movers run_alone(const World& world, const People& people, const PeopleSettings& settings,
                 double horizon) {
  Crowd crowd(world, people, settings);
  CrowdRecord record(people, horizon);
  for (;; crowd.move()) {
    crowd.decide();
    record.add(crowd);
    if (crowd.time() >= horizon) return record.take();
  }
}

}  // namespace slalom
