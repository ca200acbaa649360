// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/people/run_alone.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

bool same_place(const Waypoint& a, const Waypoint& b) {
  return a.position.x == b.position.x && a.position.y == b.position.y;
}

}  // namespace

CrowdRecord::CrowdRecord(const People& people, double horizon, Movers others)
    : first_(others.size()), movers_(std::move(others)) {
  for (const Person& person : people)
    movers_.push_back({person.id, person.radius, {{horizon + 1, person.start}}});
}

void CrowdRecord::add(const Crowd& crowd) {
  for (std::size_t i = 0; i < crowd.walkers().size(); ++i) {
    const Walker& walker = crowd.walkers()[i];
    const bool vanishes = walker.departure && *walker.departure == crowd.time();
    if (!walker.is_present && !vanishes) continue;
    Mover& mover = movers_[first_ + i];
    std::vector<Waypoint>& waypoints = mover.waypoints;
    const Waypoint here{crowd.time(), walker.disc.position};
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
  for (const Walker& walker : crowd.walkers())
    arrivals.push_back(walker.arrival && *walker.arrival <= until ? walker.arrival : std::nullopt);
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
  constexpr double kShift = 1e-12;  // m
  if (!beside_) {
    People people = world_.scenario().people();
    double& x = people[0].start.x;
    x = std::max(x + kShift, std::nextafter(x, std::numeric_limits<double>::infinity()));
    beside_.emplace(world_, people, settings_);
  }
  for (; beside_->time() <= until; beside_->move()) beside_->decide();
  return arrivals_in(*beside_, until);
}

const std::vector<double>& PeopleAlone::covered(int updates) {
  for (;; now_.decide(), now_.move()) {
    if (static_cast<std::size_t>(now_.updates()) == covered_.size()) {
      std::vector<double>& covered = covered_.emplace_back();
      for (std::size_t i = 0; i < now_.walkers().size(); ++i) covered.push_back(now_.covered(i));
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
