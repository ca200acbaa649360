// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/people/people_settings.h>
#include <slalom/people/velocity_program.h>

#include <vector>

namespace slalom {

/// A person or the robot at an update, as others see it.
struct CrowdDisc {
  mrpt::math::TPoint2D position, velocity;  ///< m, m/s
  double radius = 0;                        ///< m
};

/// Someone near a person.
struct Neighbor {
  CrowdDisc disc;
  int rank = 0;             ///< order of ids; -1: the robot
  double share = 0.5;       ///< of the avoidance between the two that the person takes
  bool is_visible = true;   ///< no wall between the two centers
  bool keeps_apart = true;  ///< the person does not cross the middle between the two
};

/// A point of a wall near a person.
struct WallPoint {
  mrpt::math::TPoint2D offset;  ///< m, from the person; the nearest point of a run
  bool faces_person = true;     ///< the free side of the run is that of the person
};

/// The situation in which a person chooses a velocity.
struct Neighborhood {
  CrowdDisc self;
  int rank = 0;
  mrpt::math::TPoint2D wanted;  ///< m/s
  double max_speed = 0;         ///< m/s
  std::vector<Neighbor> neighbors;
  std::vector<WallPoint> walls;
};

/// Sorts neighbors and walls by their places relative to the person: results keep their bits in any
/// order of people, if the scenario is turned by 90 degrees, or mirrored together with `side`.
void sort_by_place(Neighborhood& around, PeopleSide side);

/// Bounds that rest keeps: the person does not cross, for each wall, the line through its nearest
/// point within the wall horizon, nor within a period the line half-way to a neighbor that it keeps
/// apart from.
std::vector<VelocityBound> hard_bounds(const Neighborhood& around, const PeopleSettings& settings);

}  // namespace slalom
