// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "failure_hypothesis.h"

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// The smallest scenario so far, and the test that decides whether another one replaces it.
class Shrinker {
 public:
  Shrinker(FailureTest& test, Scenario scenario, const FalsificationSetup& setup)
      : test_(test), setup_(setup), scenario_(std::move(scenario)) {}

  const Scenario& scenario() const { return scenario_; }
  const Trial& trial() { return test_.trial(scenario_); }
  double resolution() const { return setup_.run.simulation.resolution; }
  const FalsificationSetup& setup() const { return setup_; }
  const FailureTest& test() const { return test_; }
  FailureTest& test() { return test_; }

  /// Replaces the scenario by the one that `make` returns if that is the same failure, fairly.
  /// False if it is not, is the same scenario, or is invalid: `make` may throw Error.
  bool accept(const std::function<Scenario()>& make);

 private:
  FailureTest& test_;
  const FalsificationSetup& setup_;
  Scenario scenario_;
};

// The steps of shrinking. Each returns whether it made the scenario simpler.
bool remove_obstacles(Shrinker& shrinker);
bool move_start_and_goal(Shrinker& shrinker);
bool crop_workspace(Shrinker& shrinker);
bool simplify_shapes(Shrinker& shrinker);
bool shorten_routes(Shrinker& shrinker);  ///< of people
bool round_numbers(Shrinker& shrinker);

/// The removals of single obstacles of the smallest scenario; of maps, of connected groups of cells
/// (of points: their squares) and of the finest blocks.
struct RemovalRound {
  std::vector<std::pair<std::string, Judgment>> removals;  ///< description of the part, verdict
  std::set<std::string> hashes;                            ///< of the scenarios without these parts
  bool minimal = false;  ///< none was accepted, and all could be run
};
/// Removes each obstacle alone, again from the beginning after a removal that is accepted.
RemovalRound remove_each_once(Shrinker& shrinker);

/// The block side of the finest parts of grids and points that are removed; see ObstacleParts.
constexpr int kFinestBlock = 4;

}  // namespace slalom
