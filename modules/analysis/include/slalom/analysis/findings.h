#pragma once

#include <slalom/analysis/cross_table.h>

#include <string>
#include <vector>

namespace slalom {

/// What a cross table shows in one column, as a sentence that claims no more than the intervals do:
/// the two bins that differ most among those whose intervals do not overlap, e.g. "nd: success 0.98
/// [0.91, 1] at density in [0, 0.1), 0.41 [0.28, 0.55] at density in [0.3, 0.4]"; otherwise that no
/// difference is shown, or that there are too few runs (fewer than two bins with 10 values).
/// Empty for a table with fewer than two bins.
std::string finding(const CrossTable& table, std::size_t column);

/// The findings of a table's deterministic columns.
std::vector<std::string> findings(const CrossTable& table);

}  // namespace slalom
