#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/analysis/rank_statistics.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// What a comparison may claim of the second side against the first.
enum class Verdict {
  Better,        ///< the corrected test and the interval both show it
  Worse,         ///< likewise
  Different,     ///< likewise, where neither direction is better
  NoDifference,  ///< not shown, though a relevant difference would have been, with stated power
  NotEnough      ///< not shown, and too few scenarios to say so
};

/// How comparisons are made.
struct ComparisonOptions {
  AnalysisOptions analysis;        ///< 1 - confidence is the level of the tests
  std::optional<double> relevant;  ///< difference that matters; none: 0.05 of rates, otherwise 5 %
                                   ///< of the mean size of both sides
  double power = 0.8;              ///< with which that difference is to be shown
};

/// One side: a method in one set of results.
struct Side {
  const RunColumns* table = nullptr;
  std::string method;
  std::string name;  ///< as sentences call it
};

/// Side b against side a in one metric. Runs are paired by scenario (its hash) and repetition, and
/// averaged over the repetitions of a scenario; differences are b - a.
struct PairedComparison {
  std::string a, b;  ///< names of the sides
  Column column;
  std::size_t scenarios = 0;                         ///< with a pair of values
  std::size_t pairs = 0;                             ///< of runs with values on both sides
  std::size_t without_value = 0;                     ///< pairs of runs in which a side has none
  std::size_t unpaired = 0;                          ///< runs of either side that have no partner
  std::optional<double> mean_a, mean_b, difference;  ///< over scenarios
  std::optional<Interval> interval;                  ///< of the difference
  std::size_t higher = 0, lower = 0, equal = 0;      ///< scenarios by the sign of the difference

  enum class Test { None, McNemarExact, SignedRankExact, SignedRankNormal };
  Test test = Test::None;  ///< McNemar of rates with one run a scenario, else Wilcoxon
  double p = 1;
  double adjusted_p = 1;              ///< by Holm, over the family that was compared at once
  std::optional<Shift> shift;         ///< Hodges and Lehmann's, of metrics that are no rates
  std::optional<double> superiority;  ///< Vargha and Delaney's A12 of b over a, by scenario

  double confidence = 0.95, power = 0.8;
  double relevant = 0;               ///< difference that was looked for
  std::size_t scenarios_needed = 0;  ///< to show it with that power; 0: cannot be told
  Verdict verdict = Verdict::NotEnough;
};

/// Compares one pair; `adjusted_p` is `p` until `finish_family`. Throws Error (Usage) for unknown
/// names, Error (Usage) where no run has a partner.
PairedComparison compare_pair(const Side& a, const Side& b, const std::string& metric,
                              const ComparisonOptions& options);

/// Corrects the p values of comparisons made at once, and gives verdicts.
void finish_family(std::vector<PairedComparison>& family);

/// Every pair of methods of a table (or each against `baseline`) in every metric, as one family.
std::vector<PairedComparison> compare_methods(const RunColumns& table,
                                              const std::vector<std::string>& metrics,
                                              const std::string& baseline,
                                              const ComparisonOptions& options);

/// Each method that both have, or the one of each where both have just one; b against a, as one
/// family. Throws Error (Usage) where they have nothing in common.
std::vector<PairedComparison> compare_results(const RunColumns& a, const RunColumns& b,
                                              const std::vector<std::string>& metrics,
                                              const ComparisonOptions& options);

std::string to_string(Verdict verdict);              ///< "no difference shown"
std::string to_string(PairedComparison::Test test);  ///< "exact McNemar test"
std::string verdict_sentence(const PairedComparison& comparison);

}  // namespace slalom
