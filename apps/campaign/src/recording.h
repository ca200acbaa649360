#pragma once

#include <slalom/campaign/campaign.h>

#include <string>

namespace slalom {

/// Lets the runs that [record] asks for be written as rawlogs into a folder beside the result file:
/// runs.rawlogs/HASH8_METHOD_REPETITION.rawlog beside runs.results. Throws Error (Job) when the
/// folder cannot be made. The campaign must stay where it is.
void record_rawlogs(Campaign& campaign, const std::string& results_path);

}  // namespace slalom
