#pragma once

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/summary.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// The page that lists these runs (indexes into the results' runs) under that title.
using RunsLink =
    std::function<std::string(const std::string& title, const std::vector<std::size_t>& runs)>;

/// One row per method: outcomes as a bar and in numbers, then one cell per column, each a link to
/// its runs.
std::string html_summary_table(const SummaryTable& table, const ResultTable& results,
                               const RunsLink& link);

/// Cross tables over the same rows, one per method; shades and whiskers of a column share one scale
/// across them. `methods` gives the methods' order, for their colours. Each cell is a link to its
/// runs.
std::string html_cross_tables(const std::vector<CrossTable>& tables, const ResultTable& results,
                              const std::vector<std::string>& methods, const RunsLink& link);

}  // namespace slalom
