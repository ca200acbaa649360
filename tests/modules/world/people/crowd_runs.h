// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/distance.h>
#include <slalom/core/geometry.h>
#include <slalom/core/random.h>
#include <slalom/people/crowd.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace slalom::testing {

constexpr double kRadius = 0.25;  // m, of people unless stated otherwise

inline World world_with(const Bounds& bounds, std::vector<Polygon> polygons, double resolution) {
  const mrpt::math::TPoint2D corner(bounds.x_min, bounds.y_min);
  return World(Scenario::continuous("people", bounds, {{}, std::move(polygons)},
                                    {corner.x, corner.y, 0}, corner),
               resolution);
}

inline World empty_world(double half_size, double resolution = 0.5) {
  return world_with({-half_size, -half_size, half_size, half_size}, {}, resolution);
}

/// The open rectangle: no cell beside it is touched.
inline Polygon rectangle(double x_min, double y_min, double x_max, double y_max) {
  constexpr double kInset = 1e-6;
  const double a = x_min + kInset, b = y_min + kInset, c = x_max - kInset, d = y_max - kInset;
  return {{{a, b}, {c, b}, {c, d}, {a, d}}};
}

inline Person walker(std::size_t i, const mrpt::math::TPoint2D& start,
                     std::vector<mrpt::math::TPoint2D> route, PersonEnd after = PersonEnd::Stay,
                     double speed = 1.3) {
  return {"p" + std::to_string(100 + i), kRadius, speed, start, std::move(route), 0, after};
}

/// m, the least gap between two people from this update to the next one.
inline double least_gap(const Crowd& crowd, double period) {
  double least = std::numeric_limits<double>::infinity();
  const std::vector<PersonState>& walkers = crowd.states();
  for (std::size_t i = 0; i < walkers.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const PersonState &a = walkers[i], &b = walkers[j];
      if (!a.is_present || !b.is_present) continue;
      const mrpt::math::TPoint2D from = b.disc.position - a.disc.position;
      const auto nearest = nearest_on_segment({0, 0}, from, from + (b.chosen - a.chosen) * period);
      least = std::min(least, nearest.norm() - a.disc.radius - b.disc.radius);
    }
  return least;
}

struct CrowdResult {
  double gap = std::numeric_limits<double>::infinity();       ///< m, between people
  double wall_gap = std::numeric_limits<double>::infinity();  ///< m, at updates
  double last_arrival = 0;                                    ///< s
  std::size_t arrived = 0;
};

/// Runs until all have arrived, or up to `until` (s).
inline CrowdResult run_crowd(const World& world, const People& people,
                             const PeopleSettings& settings, double until) {
  Crowd crowd(world, people, settings);
  CrowdResult result;
  for (;; crowd.move()) {
    crowd.decide();
    result.gap = std::min(result.gap, least_gap(crowd, settings.period));
    result.arrived = 0;
    for (const PersonState& walker : crowd.states()) {
      if (walker.is_present)
        result.wall_gap =
            std::min(result.wall_gap,
                     world.distance_field().clearance(walker.disc.position) - walker.disc.radius);
      if (!walker.arrival) continue;
      ++result.arrived;
      result.last_arrival = std::max(result.last_arrival, *walker.arrival);
    }
    if (result.arrived == people.size() || crowd.time() >= until) return result;
  }
}

/// Up to `count` people at random places with room, with random goals.
inline People random_people(RandomEngine& random, const World& world, int count, PersonEnd after,
                            const std::vector<CrowdDisc>& occupied = {}) {
  const Bounds b = world.occupancy().bounds();
  const auto place = [&] {
    return mrpt::math::TPoint2D(uniform_real(random, b.x_min, b.x_max),
                                uniform_real(random, b.y_min, b.y_max));
  };
  const auto has_room = [&](const mrpt::math::TPoint2D& p) {
    return world.distance_field().clearance(p) > kRadius + 0.05;
  };
  People people;
  for (int tries = 0; tries < 100 * count && people.size() < std::size_t(count); ++tries) {
    const mrpt::math::TPoint2D start = place(), goal = place();
    const bool is_free =
        std::all_of(people.begin(), people.end(),
                    [&](const Person& p) {
                      return distance_between(p.start, start) > 2 * kRadius + 0.1;
                    }) &&
        std::all_of(occupied.begin(), occupied.end(), [&](const CrowdDisc& disc) {
          return distance_between(disc.position, start) > kRadius + disc.radius + 0.1;
        });
    if (is_free && has_room(start) && has_room(goal))
      people.push_back(walker(people.size(), start, {goal}, after));
  }
  return people;
}

inline PeopleSettings settings_of(PeopleModel model) {
  PeopleSettings settings;
  settings.model = model;
  return settings;
}

constexpr PeopleModel kModels[] = {PeopleModel::Speed, PeopleModel::Orca};

}  // namespace slalom::testing
