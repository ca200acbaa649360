// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/generation/moving.h>

#include <algorithm>
#include <string>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Whether no segment is so short that its time would not be that of the speed.
bool has_long_segments(const std::vector<Waypoint>& walk) {
  constexpr double kShortest = 10 * kMinSegmentDuration;
  for (std::size_t i = 1; i < walk.size(); ++i)
    if (walk[i].t - walk[i - 1].t < kShortest) return false;
  return walk.size() > 1;
}

/// The farthest waypoint of a walk that people walk to and fro, else the last one.
const TPoint2D& end_of(const std::vector<Waypoint>& walk, MoverEnd after) {
  return walk[walk.size() - (after == MoverEnd::Loop ? 2 : 1)].position;
}

/// Whether people may start and end there besides the others.
bool has_room(const std::vector<Waypoint>& walk, double radius, MoverEnd after,
              const Movers& others) {
  return std::all_of(others.begin(), others.end(), [&](const Mover& other) {
    const double apart = radius + other.radius + kWallMargin;
    return distance_between(walk[0].position, other.waypoints[0].position) >= apart &&
           (after == MoverEnd::Vanish ||
            distance_between(end_of(walk, after), end_of(other.waypoints, after)) >= apart);
  });
}

PersonEnd end_as_person(MoverEnd after) {
  return after == MoverEnd::Stop   ? PersonEnd::Stay
         : after == MoverEnd::Loop ? PersonEnd::Return
                                   : PersonEnd::Vanish;
}

Person as_person(const Mover& mover, std::size_t index) {
  const auto& walk = mover.waypoints;
  const Waypoint &last = walk.back(), &before = walk[walk.size() - 2];
  const double speed = distance_between(before.position, last.position) / (last.t - before.t);
  Person person{"person_" + std::to_string(index), mover.radius, speed, walk[0].position, {}};
  // The first end of a loop is passed on the way to the other one.
  if (mover.after == MoverEnd::Loop) person.route.push_back(walk[1].position);
  person.route.push_back(end_of(walk, mover.after));
  person.after = end_as_person(mover.after);
  return person;
}

}  // namespace

std::vector<Waypoint> walk_along(const std::vector<TPoint2D>& path, double speed, double begin) {
  Mover mover;
  for (const TPoint2D& position : path) mover.waypoints.push_back({begin, position});
  set_speed(mover, speed);
  if (begin > 0) mover.waypoints.insert(mover.waypoints.begin(), {0, path[0]});
  return mover.waypoints;
}

Movers sample_movers(RandomEngine& engine, const MoverOptions& options, MoverEnd after,
                     const TPoint2D& start, double clear_radius, const WalkSampler& sample,
                     bool are_people) {
  constexpr int kTries = 60;
  const int count = uniform_int(engine, options.min_movers, options.max_movers);
  Movers movers;
  for (int i = 0; i < count; ++i) {
    const double radius = uniform_real(engine, options.min_radius, options.max_radius);
    const double speed = uniform_real(engine, options.min_speed, options.max_speed);
    for (int k = 0; k < kTries; ++k) {
      std::vector<Waypoint> walk = sample(radius, speed);
      if (!has_long_segments(walk) ||
          distance_between(walk[0].position, start) < radius + clear_radius ||
          (are_people && !has_room(walk, radius, after, movers)))
        continue;
      movers.push_back({"mover_" + std::to_string(movers.size()), radius, std::move(walk), after});
      break;
    }
  }
  return movers;
}

Scenario with_moving(const Scenario& scenario, Movers movers, bool are_people) {
  if (!are_people) return scenario.with_movers(std::move(movers));
  People people;
  for (const Mover& mover : movers) people.push_back(as_person(mover, people.size()));
  return scenario.with_people(std::move(people));
}

void MoverOptions::visit(OptionVisitor& v) {
  v.option("min_movers", min_movers, "-", "minimum number of moving obstacles",
           Range::between(0, 1000));
  v.option("max_movers", max_movers, "-", "maximum number of moving obstacles",
           Range::between(0, 1000));
  v.option("min_radius", min_radius, "m", "minimum radius of a moving obstacle", Range::positive());
  v.option("max_radius", max_radius, "m", "maximum radius of a moving obstacle", Range::positive());
  v.option("min_speed", min_speed, "m/s", "minimum speed of a moving obstacle",
           Range::between(0.01, 100));
  v.option("max_speed", max_speed, "m/s", "maximum speed of a moving obstacle",
           Range::between(0.01, 100));
}

}  // namespace slalom
