#pragma once

#include <string>

namespace slalom {

/// The folder beside a result file in which the rawlogs of its runs lie: runs.rawlogs beside
/// runs.results.
std::string rawlog_folder(const std::string& results_path);

/// Where the rawlog of one run lies if it was recorded: FOLDER/HASH8_METHOD_REPETITION.rawlog.
std::string rawlog_path(const std::string& results_path, const std::string& scenario_hash,
                        const std::string& method, int repetition);

}  // namespace slalom
