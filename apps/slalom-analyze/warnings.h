#pragma once

#include <slalom/results/result_table.h>

#include <string>

namespace slalom {

/// Reports on standard error what is missing in the results that were read from `path`: damaged
/// rows and, of a folder with an incomplete campaign, the number of runs.
void warn_of_missing(const std::string& path, const ResultTable& runs);

}  // namespace slalom
