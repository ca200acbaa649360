#pragma once

#include <slalom/analysis/cross_table.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// What a cross table shows in one column, claiming no more than the intervals do.
struct Finding {
  enum class Verdict {
    Difference,    ///< two bins have intervals that do not overlap
    NoDifference,  ///< none have: which does not prove that there is no difference
    TooFewRuns     ///< fewer than two bins have 10 values
  };
  std::string method, descriptor, metric;  ///< ids
  Verdict verdict = Verdict::TooFewRuns;
  std::string text;  ///< a sentence
};

/// The finding of one column. A difference names the two bins that differ most among those whose
/// intervals do not overlap, e.g. "nd: success 0.98 [0.91, 1.00] at density in [0, 0.1), 0.41
/// [0.28, 0.55] at density in [0.3, 0.4]". None for a table with fewer than two bins.
std::optional<Finding> find_difference(const CrossTable& table, std::size_t column);

/// The findings of a table's deterministic columns.
std::vector<Finding> findings(const CrossTable& table);

}  // namespace slalom
