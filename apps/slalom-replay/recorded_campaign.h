#pragma once

#include <slalom/campaign/campaign_options.h>
#include <slalom/core/ini_file.h>
#include <slalom/rawlog/run_reader.h>
#include <slalom/results/run_record.h>
#include <slalom/scenario/scenario.h>

#include <string>
#include <vector>

namespace slalom {

/// The campaign's .ini that stands in a recorded run, or that of `config` where it is not empty,
/// with overrides SECTION.KEY=VALUE.
IniFile campaign_of(const RecordedRun& run, const std::string& path, const std::string& config,
                    const std::vector<std::string>& overrides);

/// The scenario of a recorded run. Throws Error (File) when it is not the one that was driven.
Scenario scenario_of(const RecordedRun& run, const std::string& path);

/// Which run it was and how it ended; without what is measured of its trajectory.
RunRecord record_of(const RecordedRun& run);

}  // namespace slalom
