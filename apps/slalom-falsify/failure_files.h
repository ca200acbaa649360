// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "arguments.h"

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

/// Writes failures.scenarios (the list of the smallest scenarios), failures.ini (a campaign that
/// runs method and witnesses in them), failures.json, and NAME.scenario.yaml, NAME.svg of each.
/// `search` is added to failures.json under "search", unless empty: JSON. Throws Error (Job).
void write_failures(const std::vector<Failure>& failures, const FalsifyCampaign& campaign,
                    const std::string& folder, const std::string& search = "");

/// The campaign's .ini with the list in `list_path` as its only source of scenarios.
IniFile ini_of_list(const FalsifyCampaign& campaign, const std::string& list_path,
                    RecordedRuns rawlogs);

/// Text for people: the failure, why it is fair, and the proof that each part of it is needed.
std::string failure_text(const Failure& failure, const TestBench& bench);

/// The commands that run and show a failure.
std::string show_command(const Failure& failure, const TestBench& bench, const std::string& folder);

}  // namespace slalom
