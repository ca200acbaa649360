#pragma once

#include "wire.h"

#include <slalom/campaign/campaign.h>

namespace slalom {

/// Describes a scenario and finds its reference paths, from scratch. Meant for a process of its
/// own: OMPL's random generators are seeded once per process.
ScenarioFindings survey_scenario(const Campaign& campaign, const Scenario& scenario);

}  // namespace slalom
