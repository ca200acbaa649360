// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/analysis_request.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// Writes the report of the results with an index into a folder.
using WriteReport = std::function<void(std::size_t index, const std::string& folder)>;

/// Writes a report of each of several results into the folder DIR/1-NAME, DIR/2-NAME, ..., and
/// DIR/index.html: new failures first, which lead to their replay, then each metric by result.
/// `paths` are those of `results`, files or folders of shards.
void report_history(const std::vector<std::string>& paths, const std::vector<ResultTable>& results,
                    const AnalysisRequest& request, const std::string& folder,
                    const WriteReport& write_report);

}  // namespace slalom
