// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/core/enum_names.h>
#include <slalom/statistics/rank_statistics.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The conclusion about the second side compared with the first.
enum class Verdict {
  Better,        ///< significant by the corrected test and the deciding_interval()
  Worse,         ///< likewise
  Different,     ///< likewise, for a metric without direction
  NoDifference,  ///< not significant, with sufficient power for a relevant difference
  NotEnough,     ///< not significant, with too few scenarios for that power
  Unconfirmed,   ///< the interval excludes 0, but the corrected test does not reject, or vice versa
  Identical,     ///< all values are equal; not a test
  OtherSettings  ///< none: the campaigns of the sides differ, see task_differences()
};
constexpr auto enum_names(Verdict) {
  return std::array{"better",          "worse",         "different", "no difference shown",
                    "not enough runs", "not confirmed", "identical", "other settings"};
}

/// Options of comparisons.
struct ComparisonOptions {
  AnalysisOptions analysis;        ///< 1 - confidence is the level of the tests
  std::optional<double> relevant;  ///< smallest difference of interest; none: 0.05 for rates,
                                   ///< otherwise 5 % of the mean magnitude of both sides
  double power = 0.8;              ///< statistical power for that difference
  bool unpaired = false;           ///< compare without pairs if no pair has_partners()
  bool despite_settings = false;   ///< verdicts also of campaigns with other settings
};

/// One side: a method in one set of results.
struct Side {
  const ResultTable* table = nullptr;
  std::string method;
  std::string name;  ///< in texts
};

/// Side b against side a in one metric. Runs are paired by scenario (its hash) and repetition, and
/// averaged over the repetitions of a scenario; differences are b - a.
struct PairedComparison {
  std::string a, b;  ///< names of the sides
  Column column;
  std::size_t scenarios = 0;      ///< with a pair of values; of the smaller side if unpaired
  std::size_t pairs = 0;          ///< of runs with values on both sides
  std::size_t without_value = 0;  ///< pairs of runs with a missing value
  std::size_t unpaired = 0;       ///< runs of either side without a partner
  std::optional<double> mean_a, mean_b, difference;  ///< over scenarios
  std::optional<Interval> interval;  ///< of the difference; none of values without bounds
  std::optional<double> ratio;       ///< of the geometric means, b / a, of positive values that
                                     ///< states_median()
  std::optional<Interval> ratio_interval;
  std::size_t higher = 0, lower = 0, equal = 0;  ///< scenarios by the sign of the difference
  bool identical = false;                        ///< all pairs of runs have equal values

  enum class Test {
    None,
    McNemarExact,
    SignedRankExact,
    SignedRankNormal,
    FisherExact,
    RankSumExact,
    RankSumNormal
  };
  /// McNemar (if unpaired Fisher) for rates with one run per scenario, else Wilcoxon (if unpaired
  /// Mann and Whitney).
  Test test = Test::None;
  double p = 1;
  double adjusted_p = 1;              ///< by Holm, over the family of comparisons
  std::size_t family = 1;             ///< number of tests in it
  std::string baseline;               ///< all pairs of the family have it; empty: all pairs
  std::optional<Shift> shift;         ///< Hodges-Lehmann, of paired or of all differences b - a,
                                      ///< for metrics that are not rates
  std::optional<double> superiority;  ///< Vargha-Delaney A12 of b over a, by scenario

  double confidence = 0.95, power = 0.8;
  double relevant = 0;                 ///< smallest difference of interest
  std::size_t required_scenarios = 0;  ///< for that difference and power; 0: unknown
  Verdict verdict = Verdict::NotEnough;

  bool other_settings = false;                   ///< so that there is no verdict
  bool is_unpaired = false;                      ///< see compare_unpaired()
  std::size_t scenarios_a = 0, scenarios_b = 0;  ///< with a value, if unpaired
  std::size_t runs_without_value = 0;            ///< of either side, if unpaired

  /// Whether a scenario and repetition has runs of both sides.
  bool has_partners() const { return pairs + without_value > 0; }
};
constexpr auto enum_names(PairedComparison::Test) {
  return std::array{"no test",          "exact McNemar test",  "exact signed-rank test",
                    "signed-rank test", "Fisher's exact test", "exact Mann-Whitney test",
                    "Mann-Whitney test"};
}

/// The interval on which a verdict depends, besides the test, and its value without a difference.
struct DecidingInterval {
  std::optional<Interval> interval;
  double null = 0;
};
/// It is that of the mean difference for rates and scores, for other metrics of the ratio, or of
/// the shift, which go with the tests by ranks: an interval of their mean is wide, as it holds for
/// any distribution, or does not exist.
DecidingInterval deciding_interval(const PairedComparison& comparison);

/// Compares one pair; `adjusted_p` is `p` until `finish_families`. Throws Error (Usage) for unknown
/// names.
PairedComparison compare_pair(const Side& a, const Side& b, const std::string& metric,
                              const ComparisonOptions& options);

/// The same of runs without common scenarios: the sides are independent samples of scenarios.
PairedComparison compare_unpaired(const Side& a, const Side& b, const std::string& metric,
                                  const ComparisonOptions& options);

/// Corrects the p values of comparisons, and sets the verdicts. Those of one metric are a family,
/// whichever metrics are compared with it. Sides that are identical or have no common pair do not
/// enter: without a difference no sign can reject (Tarone 1990).
void finish_families(std::vector<PairedComparison>& comparisons);

/// "Holm over 6 pairs", or "Holm over 3 pairs with nd" for a baseline.
std::string family_text(const PairedComparison& comparison);

/// Every pair of methods of a table (or each against `baseline`) in every metric. `method` leaves
/// the pairs with it, and does not change their families. Throws Error (Usage) for unknown names,
/// and if no pair has_partners(), unless the options allow unpaired comparisons.
std::vector<PairedComparison> compare_methods(const ResultTable& table,
                                              const std::vector<std::string>& metrics,
                                              const std::string& baseline,
                                              const ComparisonOptions& options,
                                              const std::string& method = "");

/// The same in success, and in those of the columns that have a direction, except measured times.
/// Empty if nothing can be compared: a single method, or no common scenarios.
std::vector<PairedComparison> directed_comparisons(const ResultTable& table,
                                                   const std::vector<Column>& columns,
                                                   const ComparisonOptions& options);

/// Each method that both results contain, or the single method of each; b against a. `method` (of
/// either) leaves its pair, as above. Throws Error (Usage) if they have nothing in common.
std::vector<PairedComparison> compare_results(const ResultTable& a, const ResultTable& b,
                                              const std::vector<std::string>& metrics,
                                              const ComparisonOptions& options,
                                              const std::string& method = "");

std::string verdict_sentence(const PairedComparison& comparison);

}  // namespace slalom
