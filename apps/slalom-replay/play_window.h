// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/campaign_options.h>
#include <slalom/rawlog/run_reader.h>
#include <slalom/scenario/scenario.h>

#include <string>

namespace slalom {

/// Replays a recorded run in a window until it is closed; with a script (a file name, see
/// docs/guide/studio.md) until the script ends. Throws Error (Job) if no window can be opened.
void show_run(const RecordedRun& run, const Scenario& scenario, const CampaignOptions& options,
              const std::string& log, const std::string& script);

}  // namespace slalom
