// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/progress.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// A merged campaign.
struct MergeReport {
  std::size_t files = 0, runs = 0, planned = 0, duplicates = 0;
  std::string missing;  ///< "shards 3,7,12-15", "24 runs"; "" if it is complete
};

/// Merges result files of one campaign into the file at `output`, which is replaced when all were
/// read. Throws Error: File for a file that cannot be read, of another campaign, or with other
/// results for the same run; Job, with what is missing, if the campaign is not complete, unless
/// `allow_incomplete`. An existing output is kept then.
MergeReport merge_campaign(const std::vector<std::string>& files, const std::string& output,
                           bool allow_incomplete, Progress& progress);

}  // namespace slalom
