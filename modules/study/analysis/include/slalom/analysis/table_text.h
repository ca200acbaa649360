// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/summary.h>

#include <string>
#include <vector>

namespace slalom {

/// Tables for a terminal, at most 120 columns wide (wider tables continue below), UTF-8,
/// ending with a newline. Each cell has two lines: "0.951 [0.940, 0.960]" and "±0.031 n=56 NA=4".
std::string render_summary_text(const SummaryTable& table);

/// Includes NA reasons, the runs that were left out, and the findings.
std::string render_cross_table_text(const CrossTable& table);

/// The summary per method, then the cross tables of each specification and method. Throws Error
/// (Usage) for unknown ids.
std::string render_tables_text(const ResultTable& table, const std::vector<BinSpec>& rows,
                               const std::vector<std::string>& columns, double confidence);

}  // namespace slalom
