// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/campaign_options.h>
#include <slalom/core/ini_file.h>
#include <slalom/rawlog/run_reader.h>
#include <slalom/results/run_record.h>
#include <slalom/scenario/scenario.h>

#include <string>
#include <vector>

namespace slalom {

/// The campaign .ini of a recorded run, or of the file `config` if it is not empty, with overrides
/// SECTION.KEY=VALUE.
IniFile campaign_of(const RecordedRun& run, const std::string& path, const std::string& config,
                    const std::vector<std::string>& overrides);

/// The scenario of a recorded run. Throws Error (File) if it does not match the recorded hash.
Scenario scenario_of(const RecordedRun& run, const std::string& path);

/// Identity and outcome of the run, without metrics.
RunRecord record_of(const RecordedRun& run);

}  // namespace slalom
