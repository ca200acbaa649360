// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/block_runner.h>

#include <memory>
#include <string>
#include <vector>

namespace slalom {

using SharedScenarios = std::shared_ptr<const std::vector<Scenario>>;

/// Scenarios of a search: no scenario is in two of them.
struct TuneScenarios {
  SharedScenarios development, finals, sealed;
};

struct TuneSizes {
  std::size_t development = 240, finals = 300, sealed = 400;
  std::string stratify = "density";  ///< a descriptor
  int jobs = 1;
};

/// Draws them from the sources of the .ini, each set from a random stream of its own; or divides
/// the list of the .ini. The development set is in the order of four bins of a descriptor in turn,
/// so that each prefix has all of them. Throws Error: Usage for a list that is too short, Job if no
/// solvable scenarios are found.
TuneScenarios make_tune_scenarios(const MethodCampaign& campaign, const TuneSizes& sizes);

/// The values of a descriptor, NaN where it is not available.
std::vector<double> descriptor_values(const std::vector<Scenario>& scenarios,
                                      const MethodCampaign& campaign, const std::string& id);

}  // namespace slalom
