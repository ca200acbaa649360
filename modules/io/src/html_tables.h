#pragma once

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/summary.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// The page and anchor where a scenario's picture stands, by its hash.
using ScenarioLink = std::function<std::string(const std::string& scenario_hash)>;

/// One row per method: outcomes as a bar and in numbers, then one cell per column.
std::string html_summary_table(const SummaryTable& table);

/// Cross tables over the same rows, one per method; shades and whiskers of a column share one scale
/// across them. `places` gives the methods' order, for their colours.
std::string html_cross_tables(const std::vector<CrossTable>& tables, const ResultTable& results,
                              const std::vector<std::string>& methods, const ScenarioLink& link);

}  // namespace slalom
