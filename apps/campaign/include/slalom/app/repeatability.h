// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/campaign_program.h>

#include <string>

namespace slalom {

/// Executes [record] repeated_runs of the runs of each method in the file a second time, those with
/// the least repetition and hash, and stores in its manifest what differs. What is stored is not
/// executed again. Says on standard error how many were the same, with arguments.quiet only for
/// methods of which one was not. Runs that a time limit or the infrastructure ended are not used,
/// and no method of which the file mixes versions. The caller holds the FileLock. Throws Error, and
/// Interrupted.
void measure_repeatability(const CampaignConfig& config, const CampaignArguments& arguments,
                           const std::string& results_path);

}  // namespace slalom
