// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cross_table.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// A statement about one column of a cross table: whether its values rise or fall over the bins.
struct Finding {
  enum class Verdict {
    Trend,      ///< the corrected test rejects
    NoTrend,    ///< it does not; this does not prove that there is none
    TooFewRuns  ///< see find_trend()
  };
  std::string method, descriptor, metric;  ///< ids
  Verdict verdict = Verdict::TooFewRuns;
  std::string text;  ///< a sentence
};

/// True if the corrected test rejects at the level of the confidence.
bool is_shown(const std::optional<Trend>& trend, double confidence);

/// The first and the last row with values in a column; nullopt if they do not differ in the
/// direction of the trend.
std::optional<std::pair<const CrossRow*, const CrossRow*>> trend_ends(const CrossTable& table,
                                                                      std::size_t column,
                                                                      bool rises);

/// The findings of all columns except wall-clock measurements, e.g. "nd: success falls with
/// density, from 0.98 [0.91, 1.00] in [0, 0.1) to 0.41 [0.28, 0.55] in [0.3, 0.4], p < 0.0001
/// (Cochran-Armitage, Holm)". None for a table with fewer than two bins.
std::vector<Finding> findings(const CrossTable& table);

/// The same, condensed: each trend, then one finding for all metrics without one ("nd: no trend
/// shown in optimality, safety by density") and one for those with too few runs.
std::vector<Finding> condensed_findings(const CrossTable& table);

}  // namespace slalom
