// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/people/crowd.h>
#include <slalom/scenario/mover.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace slalom {

/// The motion of people as moving obstacles: a waypoint per update, none while a person rests.
class CrowdRecord {
 public:
  /// A person who does not appear begins after `horizon` (s), the end of the record. The obstacles
  /// of the people follow `others`.
  CrowdRecord(const People& people, double horizon, Movers others = {});

  /// Adds the present state: after each decide(), so that people appear and vanish, and after each
  /// move() whose motion has to be known before the next decision.
  void add(const Crowd& crowd);
  /// The others, then one per person, in their order. Refers to this.
  const Movers& movers() const { return movers_; }
  Movers take() { return std::move(movers_); }

 private:
  std::size_t first_;
  Movers movers_;
};

/// s, per person; none for who has not arrived.
using Arrivals = std::vector<std::optional<double>>;

/// PersonState::arrival of each person, up to this time (s).
Arrivals arrivals_in(const Crowd& crowd, double until);

/// The people of a scenario without a robot: the start of all runs among them, and how far they
/// come alone, which is computed as far as it is asked for.
class PeopleAlone {
 public:
  /// Throws as Crowd.
  PeopleAlone(const World& world, const PeopleSettings& settings);

  const Crowd& start() const { return start_; }
  /// Crowd::covered() of each person after so many updates.
  const std::vector<double>& covered(int updates);
  /// s, the arrival of each person up to this time (s).
  Arrivals arrivals(double until);
  /// The same of a crowd whose first person with room starts 1e-12 m beside its start.
  Arrivals arrivals_beside(double until);

 private:
  const World& world_;
  PeopleSettings settings_;
  Crowd start_, now_;
  std::optional<Crowd> beside_;
  std::vector<std::vector<double>> covered_;
};

/// The motion of people without a robot from 0 to `horizon` (s) or a little further: that of all
/// runs among people who do not notice the robot. Throws as Crowd.
Movers run_alone(const World& world, const People& people, const PeopleSettings& settings,
                 double horizon);

}  // namespace slalom
