// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// The folder of the rawlogs of a result file's runs: runs.rawlogs for runs.results.
std::string rawlog_folder(const std::string& results_path);

/// The path of a run's rawlog: FOLDER/HASH8_METHOD_REPETITION.rawlog. It exists if the run was
/// recorded.
std::string rawlog_path(const std::string& results_path, const std::string& scenario_hash,
                        const std::string& method, int repetition);

/// The same of bags: runs.bags, and FOLDER/HASH8_METHOD_REPETITION.mcap.
std::string bag_folder(const std::string& results_path);
std::string bag_path(const std::string& results_path, const std::string& scenario_hash,
                     const std::string& method, int repetition);

}  // namespace slalom
