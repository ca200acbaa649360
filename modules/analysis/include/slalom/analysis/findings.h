#pragma once

#include <slalom/analysis/cross_table.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A statement about one column of a cross table, based on its confidence intervals.
struct Finding {
  enum class Verdict {
    Difference,    ///< the intervals of the two bins do not overlap
    NoDifference,  ///< they overlap; this does not prove equality
    TooFewRuns     ///< fewer than two bins have 10 values
  };
  std::string method, descriptor, metric;  ///< ids
  Verdict verdict = Verdict::TooFewRuns;
  std::string text;  ///< a sentence
};

/// The finding of one column: the lowest and the highest bin with 10 values or more, compared, e.g.
/// "nd: success 0.98 [0.91, 1.00] at density in [0, 0.1), 0.41 [0.28, 0.55] at density in [0.3,
/// 0.4]". Only these two bins are compared: selecting the most different of all pairs would inflate
/// the error rate. Under the null hypothesis, two 95 % intervals do not overlap in about one of 180
/// comparisons. None for a table with fewer than two bins.
std::optional<Finding> find_difference(const CrossTable& table, std::size_t column);

/// The findings of all columns except wall-clock measurements.
std::vector<Finding> findings(const CrossTable& table);

/// The same, condensed: each difference, then one finding for all metrics without a difference
/// ("nd: no difference shown in optimality, safety by density") and one for those with too few
/// runs.
std::vector<Finding> condensed_findings(const CrossTable& table);

}  // namespace slalom
