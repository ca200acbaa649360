// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wire.h"

#include <slalom/campaign/campaign.h>

namespace slalom {

/// Computes the descriptors and reference paths of a scenario. Call it in a separate process: OMPL
/// seeds its random number generators once per process.
ScenarioFindings survey_scenario(const Campaign& campaign, const Scenario& scenario);

}  // namespace slalom
