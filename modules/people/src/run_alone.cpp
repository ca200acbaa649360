// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/people/run_alone.h>

namespace slalom {
namespace {

bool same_place(const Waypoint& a, const Waypoint& b) {
  return a.position.x == b.position.x && a.position.y == b.position.y;
}

}  // namespace

CrowdRecord::CrowdRecord(const People& people) : people_(people) {
  for (const Person& person : people) movers_.push_back({person.id, person.radius, {}});
}

void CrowdRecord::add(const Crowd& crowd) {
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const Walker& walker = crowd.walkers()[i];
    const bool vanishes = walker.departure && *walker.departure == crowd.time();
    if (!walker.is_present && !vanishes) continue;
    std::vector<Waypoint>& waypoints = movers_[i].waypoints;
    const Waypoint here{crowd.time(), walker.disc.position};
    const std::size_t n = waypoints.size();
    if (n > 1 && same_place(waypoints[n - 1], here) && same_place(waypoints[n - 2], here))
      waypoints.pop_back();
    waypoints.push_back(here);
    if (vanishes) movers_[i].after = MoverEnd::Vanish;
  }
}

Movers CrowdRecord::movers(double horizon) const {
  Movers movers = movers_;
  for (std::size_t i = 0; i < movers.size(); ++i)
    if (movers[i].waypoints.empty()) movers[i].waypoints.push_back({horizon + 1, people_[i].start});
  return movers;
}

Movers run_alone(const World& world, const People& people, const PeopleSettings& settings,
                 double horizon) {
  Crowd crowd(world, people, settings);
  CrowdRecord record(people);
  for (;; crowd.move()) {
    crowd.decide();
    record.add(crowd);
    if (crowd.time() >= horizon) return record.movers(horizon);
  }
}

}  // namespace slalom
