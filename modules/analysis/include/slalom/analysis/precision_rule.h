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

/// The confidence of intervals at the `look`-th interim analysis (from 1): 1 - (1 - confidence) /
/// (look (look + 1)). The error probabilities of all looks sum to at most 1 - confidence (1/2 + 1/6
/// + 1/12 + ... = 1), so that intervals have at least `confidence` whenever the campaign stops
/// (Bonferroni; alpha spending, Lan and DeMets 1983).
double look_confidence(double confidence, int look);

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
                                           const AnalysisOptions& options, int look);

/// A specification with the edges of these bins.
BinSpec with_edges(const std::string& descriptor, const std::vector<Bin>& bins);

/// The cells as aligned text: n, estimate, interval, width, reached or not.
std::string render_precision_text(const PrecisionRule& rule,
                                  const std::vector<PrecisionCell>& cells);

}  // namespace slalom
