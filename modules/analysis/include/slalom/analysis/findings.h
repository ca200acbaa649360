#pragma once

#include <slalom/analysis/cross_table.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// What a cross table shows in one column, claiming no more than the intervals do.
struct Finding {
  enum class Verdict {
    Difference,    ///< the intervals of the two bins do not overlap
    NoDifference,  ///< they do: which does not prove that there is no difference
    TooFewRuns     ///< fewer than two bins have 10 values
  };
  std::string method, descriptor, metric;  ///< ids
  Verdict verdict = Verdict::TooFewRuns;
  std::string text;  ///< a sentence
};

/// The finding of one column: the lowest and the highest bin with 10 values or more, compared, e.g.
/// "nd: success 0.98 [0.91, 1.00] at density in [0, 0.1), 0.41 [0.28, 0.55] at density in [0.3,
/// 0.4]". Only these two: to pick the most different of all pairs would find differences in noise.
/// Two 95 % intervals that do not overlap come by chance about once in 180 such comparisons. None
/// for a table with fewer than two bins.
std::optional<Finding> find_difference(const CrossTable& table, std::size_t column);

/// The findings of a table's deterministic columns.
std::vector<Finding> findings(const CrossTable& table);

/// The same for people: each difference, then one finding for all metrics without one ("nd: no
/// difference shown in optimality, safety by density") and one for those with too few runs.
std::vector<Finding> condensed_findings(const CrossTable& table);

}  // namespace slalom
