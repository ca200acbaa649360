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
};

/// Names the smallest scenarios METHOD_OUTCOME_1, ...
void name_failures(std::vector<Failure>& failures, const std::string& method);

/// Writes failures.scenarios (the list of the smallest scenarios), failures.ini (a campaign that
/// runs method and witnesses in them), failures.json, and NAME.scenario.yaml, NAME.svg of each.
/// `search` is added to failures.json under "search", unless empty: JSON. Throws Error (Job).
void write_failures(const std::vector<Failure>& failures, const FalsifyCampaign& campaign,
                    const std::string& folder, const std::string& search = "");

/// What was found, why it is fair, and the proof that all of it is needed; for people.
std::string failure_text(const Failure& failure, const TestBench& bench);

/// The commands that run and show a failure.
std::string show_command(const Failure& failure, const TestBench& bench, const std::string& folder);

}  // namespace slalom
