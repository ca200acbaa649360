// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/falsification/neighbors.h>
#include <slalom/falsification/shrink.h>

#include <string>
#include <vector>

namespace slalom {

/// A failure and its smallest scenario.
struct Failure {
  std::string origin;  ///< where it was found: "run 0123abcd/mine/0", "candidate 17"
  Scenario original;
  ShrinkResult small;
  /// Scenarios similar to the failing one in which the method reaches the goal: successful ones of
  /// the mix, or the smallest scenario without each of its obstacles.
  std::vector<Scenario> neighbors = {};
  bool is_original_compared = false;  ///< with the neighbors; else the smallest scenario
  bool independent = true;            ///< see ExaminedFailure
};

/// Names the smallest scenarios METHOD_OUTCOME_1, ...
void name_failures(std::vector<Failure>& failures, const std::string& method);

/// Gives each failure the successful_neighbors() of its original; false when interrupted.
bool find_neighbors(std::vector<Failure>& failures, const FalsificationSetup& setup,
                    const NeighborOptions& options);

/// Text for people: the failure, why it is fair, and the proof that each part of it is needed.
std::string failure_text(const Failure& failure, const FalsificationSetup& setup);

/// The commands that run and show a failure of the campaign FOLDER/failures.ini.
std::string show_command(const Failure& failure, const FalsificationSetup& setup,
                         const std::string& folder);

}  // namespace slalom
