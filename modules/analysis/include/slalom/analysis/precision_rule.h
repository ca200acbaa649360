#pragma once

#include <slalom/analysis/cross_table.h>

#include <string>
#include <vector>

namespace slalom {

/// How precisely a campaign is to know a metric before it stops: the interval of `metric` narrower
/// than `width` (from its lower to its upper end) in every bin of `rows`, for every method.
struct PrecisionRule {
  std::string metric;
  double width = 0;
  BinSpec rows;
};

/// Reads "interval(success) < 0.05 in density:10"; without "in ...", over all scenarios. Throws
/// Error (Usage) saying what was expected.
PrecisionRule parse_precision_rule(const std::string& text);

/// The confidence of intervals at the `look`-th time (from 1) that a campaign looks at its results
/// to see whether it may stop: 1 - (1 - confidence) / (look (look + 1)). The error probabilities of
/// all looks add up to no more than 1 - confidence (1/2 + 1/6 + 1/12 + ... = 1), so that intervals
/// hold with `confidence` whenever the campaign stops (Bonferroni's bound; alpha spending, Lan and
/// DeMets 1983).
double look_confidence(double confidence, int look);

/// One method in one bin, and whether it is known precisely enough.
struct PrecisionCell {
  std::string method;
  Bin bin;
  Cell cell;
  bool reached = false;
};

/// The cells of a rule at one look, methods outermost. `rule.rows` must have fixed edges, or be
/// all: counted bins would move as results come in.
std::vector<PrecisionCell> precision_cells(const RunColumns& runs, const PrecisionRule& rule,
                                           const AnalysisOptions& options, int look);

/// The same bins as given edges.
BinSpec with_edges(const std::string& descriptor, const std::vector<Bin>& bins);

/// The cells as aligned text: n, estimate, interval, width, reached or not.
std::string render_precision_text(const PrecisionRule& rule,
                                  const std::vector<PrecisionCell>& cells);

}  // namespace slalom
