// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/describe_scenario.h>
#include <slalom/falsification/failure.h>

#include <string>
#include <vector>

namespace slalom {

/// Writes into an existing folder: failures.scenarios (the list of the smallest scenarios),
/// failures.json (with their descriptors), and NAME.scenario.yaml, NAME.svg of each. `search` is
/// added to failures.json under "search", unless empty: JSON, as of search_json(). Throws Error
/// (Job) when it cannot write.
void write_failures(const std::vector<Failure>& failures, const FalsificationSetup& setup,
                    const DescribeOptions& describe, const std::string& folder,
                    const std::string& search = "");

}  // namespace slalom
