// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/table_types.h>

#include <string>
#include <vector>

namespace slalom {

/// Throws Error (Usage) for an unknown column.
SummaryTable build_summary(const ResultTable& table, const std::vector<std::string>& column_ids,
                           const AnalysisOptions& options);

}  // namespace slalom
