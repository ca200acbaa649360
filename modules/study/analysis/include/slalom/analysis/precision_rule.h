// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cross_table.h>

#include <string>
#include <vector>

namespace slalom {

/// Stopping rule of a campaign: the interval of `metric` is narrower than `width` (upper minus
/// lower end) in every bin of `rows`, for every method.
struct PrecisionRule {
  std::string metric;
  double width = 0;
  BinSpec rows;
};

/// Reads "interval(success) < 0.05 in density:10"; without "in ...", over all scenarios. Throws
/// Error (Usage).
PrecisionRule parse_precision_rule(const std::string& text);

/// The confidence of intervals at each interim analysis (look): 1 - 0.6 (1 - confidence). Stopping
/// when an interval is narrow depends on the variance, hardly on the mean (Chow and Robbins 1965,
/// Ann. Math. Stat. 36:457-462), so that this small correction keeps `confidence` for rates
/// whenever the campaign stops; docs/guide/campaigns.md has the coverage by rate, width and
/// distribution.
double look_confidence(double confidence);

/// One method in one bin, and whether the required precision is reached.
struct PrecisionCell {
  std::string method;
  Bin bin;
  Cell cell;
  bool reached = false;
};

/// The cells of a rule at one look, methods outermost. `rule.rows` must be of kind Edges or All:
/// edges of other kinds depend on the results so far.
std::vector<PrecisionCell> precision_cells(const ResultTable& runs, const PrecisionRule& rule,
                                           const AnalysisOptions& options);

/// A specification with the edges of these bins.
BinSpec with_edges(const std::string& descriptor, const std::vector<Bin>& bins);

/// The cells as aligned text: n, estimate, interval, width, reached or not.
std::string render_precision_text(const PrecisionRule& rule,
                                  const std::vector<PrecisionCell>& cells);

}  // namespace slalom
