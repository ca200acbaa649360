// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/bins.h>
#include <slalom/analysis/cell.h>

#include <string>
#include <vector>

namespace slalom {

/// Relative frequency of an outcome in a group of runs.
struct OutcomeFraction {
  std::string outcome;
  std::vector<std::size_t> runs;     ///< indexes into the results
  double fraction = 0;               ///< of the group's runs
  std::optional<Interval> interval;  ///< Wilson, with the effective number of runs
};

/// The runs of one method in one bin.
struct OutcomeGroup {
  std::string method;
  Bin bin;
  std::size_t n = 0;
  std::vector<OutcomeFraction> outcomes;  ///< in the order of FailureTaxonomy::outcomes
};

struct FailureTaxonomy {
  QuantityInfo descriptor;            ///< of the bins; "all" for a single bin
  std::vector<std::string> outcomes;  ///< all that occur: success first, the others by name
  std::vector<OutcomeGroup> groups;   ///< methods outermost
  std::size_t left_out = 0;           ///< runs outside all bins, or without a value
  double confidence = 0.95;
};

/// Counts the failures of all methods, or of `method` if one is named. Throws Error (Usage) for
/// unknown names.
FailureTaxonomy build_failure_taxonomy(const ResultTable& table, const BinSpec& spec,
                                       const AnalysisOptions& options,
                                       const std::string& method = "");

}  // namespace slalom
