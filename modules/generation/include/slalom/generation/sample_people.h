// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/scenario/person.h>
#include <slalom/scenario/world.h>

#include <string>

namespace slalom {

/// People who walk to and fro among the static obstacles of a scenario.
struct PeopleOptions {
  int count = 0;
  double min_radius = 0.2, max_radius = 0.3;  ///< m
  double min_speed = 0.8, max_speed = 1.5;    ///< m/s, the preferred one of each person
};

/// The people of the scenario of `world`, and `options.count` more. Each of these walks between a
/// random start and a random goal, at least 3 m apart, by whichever way people of its radius take;
/// there is one. Starts are 0.05 m from obstacles, the border and all other starts, and so are
/// goals; starts are 1 m from a disc of `robot_radius` (m) at the start of the robot, goals at its
/// goal. Person i depends only on the world, the options, the state of `engine` and the people
/// before it. Throws Error (Job) if there is no room for a person.
People sample_people(const World& world, double robot_radius, const PeopleOptions& options,
                     RandomEngine& engine);

/// The first problem of the people in the scenario of `world`: someone starts in a wall, or in a
/// disc of `robot_radius` (m) at the start of the robot, or has no way to the next point of its
/// route. Empty if there is none.
std::string problem_of_people(const World& world, double robot_radius);

}  // namespace slalom
