// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "crowd_runs.h"
#include "orca.h"

#include <slalom/core/math.h>

#include <cmath>
#include <random>
#include <vector>

namespace slalom::testing {

/// The setting of the test cases of CrowdNav (Chen et al. 2019; vita-epfl/CrowdNav, 20d6780).
constexpr double kPeriod = 0.25, kDiscRadius = 0.3, kCircle = 4;
inline const mrpt::math::TPoint2D kRobotStart(0, -kCircle), kRobotGoal(0, kCircle);

inline PeopleSettings crowdnav_settings() {
  PeopleSettings settings;
  settings.model = PeopleModel::Orca;
  settings.period = kPeriod;
  settings.horizon = 5;
  settings.sight = 10;
  settings.margin = 0.01;
  settings.haste = 1;
  settings.turn = 0;
  settings.keep_apart = false;
  return settings;
}

/// numpy's numbers in [0, 1), from its legacy generator.
inline double uniform(std::mt19937& random) {
  const auto high = static_cast<double>(random() >> 5);
  const auto low = static_cast<double>(random() >> 6);
  return (high * 67108864.0 + low) / 9007199254740992.0;
}

inline People people_of_case(unsigned k) {
  std::mt19937 random(1000 + k);
  People people;
  while (people.size() < 5) {
    const math::SinCos angle = math::sin_cos(uniform(random) * M_PI * 2);
    const double dx = uniform(random) - 0.5, dy = uniform(random) - 0.5;
    const mrpt::math::TPoint2D start(kCircle * angle.cos + dx, kCircle * angle.sin + dy);
    const auto is_near = [&](const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b) {
      return distance_between(start, a) < 0.8 || distance_between(start, b) < 0.8;
    };
    bool bad = is_near(kRobotStart, kRobotGoal);
    for (const Person& person : people) bad = bad || is_near(person.start, person.route[0]);
    if (bad) continue;
    people.push_back(walker(people.size(), start, {start * -1.0}, PersonEnd::Stay, 1));
    people.back().radius = kDiscRadius;
  }
  return people;
}

/// The velocity by ORCA of CrowdNav's robot among people as it sees them.
inline mrpt::math::TPoint2D crowdnav_velocity(const CrowdDisc& robot,
                                              const std::vector<CrowdDisc>& people) {
  Neighborhood around;
  around.self = robot;
  around.rank = -1;
  around.max_speed = 1;
  const mrpt::math::TPoint2D offset = kRobotGoal - robot.position;
  around.wanted = offset.norm() > 1 ? offset * (1 / offset.norm()) : offset;
  int rank = 0;
  for (const CrowdDisc& person : people)
    around.neighbors.push_back({person, rank++, 0.5, true, false});
  const PeopleSettings settings = crowdnav_settings();
  sort_by_place(around, settings.side);
  return orca_velocity(around, settings);
}

}  // namespace slalom::testing
