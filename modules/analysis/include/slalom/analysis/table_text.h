#pragma once

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/summary.h>

#include <string>
#include <vector>

namespace slalom {

/// Tables for a terminal, at most 120 columns wide (wider tables continue below), UTF-8,
/// ending with a newline. Each cell has two lines: "0.951 [0.940, 0.960]" and "±0.031 n=60 NA=4".
std::string render_summary_text(const SummaryTable& table);

/// With the reasons of missing values, what was left out, and the findings below it.
std::string render_cross_table_text(const CrossTable& table);

/// Everything that a terminal is shown about results: the summary per method, then the cross tables
/// of each specification and method. Throws Error (Usage) for unknown ids.
std::string render_tables_text(const RunColumns& table, const std::vector<BinSpec>& rows,
                               const std::vector<std::string>& columns, double confidence);
std::string render_tables_text(const ResultTable& table, const std::vector<BinSpec>& rows,
                               const std::vector<std::string>& columns, double confidence);

}  // namespace slalom
