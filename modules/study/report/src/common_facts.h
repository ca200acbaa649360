// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scenario_data.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Facts about a failed run; several may be true.
enum class FailureFact { Turning, NearGoal, AtStart, Wandering, Apart, AtObstacle };
constexpr std::size_t kFailureFacts = 6;

/// Counts what the failures of each method have in common. It describes, and tests nothing.
class CommonFacts {
 public:
  CommonFacts(std::size_t methods, const RobotModel& robot);

  /// Counts run `i` of the scenario if it is a failure.
  void add(std::size_t method, const ScenarioRuns& content, const World& world, std::size_t i);

  struct Common {
    FailureFact fact;
    std::size_t count, failures;
    std::string text;  ///< "end within 2 m of the goal"
  };
  /// One of the facts that are true of half of the failures and of three: that the robot turns in
  /// place at the end (end_motion()), since such a method may turn to what its sensor does not see;
  /// else the one whose share exceeds that in the failures of the other methods most, if by 0.2 or
  /// more; else the most frequent one of at least 0.8.
  std::optional<Common> of(std::size_t method) const;

 private:
  RobotModel robot_;
  double radius_;
  struct Counts {
    std::size_t failures = 0;
    std::array<std::size_t, kFailureFacts> facts = {};
  };
  std::vector<Counts> counts_;

  bool holds(FailureFact fact, const ScenarioRuns& content, std::size_t i, double clearance) const;
  std::string text_of(FailureFact fact) const;
};

}  // namespace slalom
