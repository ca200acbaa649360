// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <string>

namespace slalom {

/// The number of runs of the complete campaign; 0 if it is not known, as with a stopping rule.
std::size_t planned_runs(const ResultTable& runs);

/// Reports on standard error that the result files of a folder, or one file (`files` is 0), contain
/// fewer runs than planned.
void warn_of_missing_runs(const std::string& folder, std::size_t files, std::size_t runs,
                          std::size_t planned);

/// Reports on standard error what is missing in the results that were read from `path`: damaged
/// rows, columns of a CSV file and, of an incomplete campaign, the number of runs.
void warn_of_missing(const std::string& path, const ResultTable& runs);

}  // namespace slalom
