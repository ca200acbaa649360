// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/people/crowd.h>
#include <slalom/scenario/mover.h>

namespace slalom {

/// The motion of people as moving obstacles: a waypoint per update, none while a person rests.
class CrowdRecord {
 public:
  explicit CrowdRecord(const People& people);

  /// Adds the present state: after each decide(), and after the last move().
  void add(const Crowd& crowd);
  /// One per person, in their order. That of a person who has not appeared begins after `horizon`
  /// (s), the end of the record.
  Movers movers(double horizon) const;

 private:
  People people_;
  Movers movers_;
};

/// The motion of people without a robot from 0 to `horizon` (s) or a little further: that of all
/// runs among people who do not notice the robot. Throws as Crowd.
Movers run_alone(const World& world, const People& people, const PeopleSettings& settings,
                 double horizon);

}  // namespace slalom
