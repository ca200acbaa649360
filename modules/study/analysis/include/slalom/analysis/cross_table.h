// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/table_types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// One cross table per specification and method (`method` empty: all methods), specifications
/// outermost. Throws Error (Usage) with the nearest name for unknown ids.
std::vector<CrossTable> build_cross_tables(const ResultTable& table,
                                           const std::vector<BinSpec>& specs,
                                           const std::vector<std::string>& column_ids,
                                           const AnalysisOptions& options,
                                           const std::string& method = "");

/// The index of a method in `table.methods`. Throws Error (Usage) with the nearest name.
std::uint32_t index_of_method(const ResultTable& table, const std::string& method);

}  // namespace slalom
