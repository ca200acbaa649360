// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/campaign_options.h>
#include <slalom/generation/sample_people.h>
#include <slalom/generation/walkers.h>
#include <slalom/methods/method_factory.h>
#include <slalom/scenario/world.h>
#include <slalom/simulation/simulate.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The method whose failures are searched, and how it is run: as in a campaign with these settings,
/// this seed and this repetition.
struct FalsificationSetup {
  RunSetup run;
  LimitsSection limits;
  std::uint64_t seed = 1;
  int repetition = 0;
  NamedMethod method;
  /// A failure counts only where one of these reaches the goal: it proves that the scenario can be
  /// solved.
  std::vector<NamedMethod> witnesses;

  /// The method itself among people who do not notice it may stand in for a witness: see
  /// witnesses_in().
  bool unnoticed_witness = false;

  /// Moving obstacles in each scenario that is drawn, besides those of the mix.
  WalkerOptions walkers = {};
  PeopleOptions people = {};  ///< likewise

  /// A light method that fails in similar scenarios: see SearchOptions.
  std::optional<NamedMethod> surrogate = {};

  /// 0: the method; then the witnesses, the surrogate, and the method among people who do not
  /// notice the robot.
  const NamedMethod& method_at(std::size_t index) const {
    if (index == 0 || index == unnoticed_index()) return method;
    return index <= witnesses.size() ? witnesses[index - 1] : surrogate.value();
  }
  std::size_t surrogate_index() const { return witnesses.size() + 1; }
  std::size_t unnoticed_index() const { return witnesses.size() + 2; }

  /// The indexes of those of which one has to reach the goal. The success of a witness proves that
  /// the scenario can be solved. That of the method itself among the same people if they do not
  /// notice it does not: those who do walk otherwise. It shows that only their reaction is in the
  /// way.
  std::vector<std::size_t> witnesses_in(const Scenario& scenario) const;
  bool has_witness() const;  ///< in a scenario that is drawn
  /// "nd"; "nd among people who do not notice it".
  std::string witness_name(std::size_t index) const;
};

/// The stored part of a run.
struct Trial {
  Outcome outcome = Outcome::InfrastructureError;
  std::string detail;
  std::string trajectory_hash;  ///< empty if the method's process died
  /// Poses (m, rad) of the robot, evenly distributed in time, with the first and the last one;
  /// empty if the method's process died.
  std::vector<mrpt::math::TPose2D> waypoints;
  double clearance = 0;  ///< m, smallest distance of the robot's enclosing disc to obstacles; <= 0
                         ///< in contact. 0 if the method's process died
};

constexpr std::size_t kWaypoints = 48;  ///< at most, of a trial

/// Runs a method in this process.
Trial run_trial(const World& world, const FalsificationSetup& setup, Method& method);

/// Whether both are the same run, to the last bit of the trajectory.
bool is_same_run(const Trial& a, const Trial& b);

std::string to_bytes(const Trial& trial);
/// Throws Error (File) at `where` for malformed bytes.
Trial trial_from_bytes(const std::string& bytes, const std::string& where);

}  // namespace slalom
