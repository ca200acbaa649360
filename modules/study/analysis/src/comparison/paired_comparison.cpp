// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_means.h"

#include <slalom/analysis/campaign_settings.h>
#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/paired_comparison.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/statistics/mean_interval.h>
#include <slalom/statistics/paired_rates.h>
#include <slalom/statistics/power.h>
#include <slalom/statistics/rank_statistics.h>
#include <slalom/statistics/two_samples.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace slalom {
namespace {

/// Asymptotic relative efficiency of both of Wilcoxon's tests to Student's under normality (Hodges
/// and Lehmann 1956).
const double kSignedRankEfficiency = 3 / M_PI;

struct Key {
  const std::string* scenario;
  std::uint32_t repetition;
  std::size_t run;

  bool operator<(const Key& other) const {
    return std::tie(*scenario, repetition) < std::tie(*other.scenario, other.repetition);
  }
};

std::vector<Key> keys_of(const Side& side) {
  const std::uint32_t method = index_of_method(*side.table, side.method);
  std::vector<Key> keys;
  for (std::size_t run = 0; run < side.table->size(); ++run) {
    if (side.table->method[run] != method) continue;
    keys.push_back({&side.table->scenario_hashes[side.table->scenario[run]],
                    side.table->repetition[run], run});
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// Values of a side, averaged by scenario.
struct SideValues {
  std::vector<double> means, successes;  ///< of the values, and of those that are not 0
  std::size_t runs = 0;                  ///< with a value

  bool one_run_each() const { return runs == means.size(); }
};

/// Averages the values of successive scenarios.
class ScenarioAverage {
 public:
  void add(double value) {
    sum_ += value;
    successes_ += value != 0 ? 1 : 0;
    ++size_;
  }
  void close(SideValues& values) {
    if (size_ == 0) return;
    const double size = static_cast<double>(size_);
    values.means.push_back(sum_ / size);
    values.successes.push_back(successes_ / size);
    values.runs += size_;
    *this = {};
  }

 private:
  double sum_ = 0, successes_ = 0;
  std::size_t size_ = 0;
};

/// Values of pairs.
struct PairedValues {
  SideValues a, b;
  bool identical = true;
};

class Pairing {
 public:
  Pairing(PairedComparison& comparison, const ValueColumn& a, const ValueColumn& b)
      : comparison_(comparison), a_(a), b_(b) {}

  void add(const Key& a, const Key& b) {
    if (a_.is_na(a.run) || b_.is_na(b.run)) {
      ++comparison_.without_value;
      return;
    }
    ++comparison_.pairs;
    if (scenario_ == nullptr || *scenario_ != *a.scenario) {
      close();
      scenario_ = a.scenario;
    }
    const double x = a_.number(a.run), y = b_.number(b.run);
    const double tolerance = kTieTolerance * std::max(std::abs(x), std::abs(y));
    values_.identical = values_.identical && std::abs(x - y) <= tolerance;
    average_a_.add(x);
    average_b_.add(y);
  }
  PairedValues values() {
    close();
    return values_;
  }

 private:
  PairedComparison& comparison_;
  const ValueColumn &a_, &b_;
  PairedValues values_;
  const std::string* scenario_ = nullptr;
  ScenarioAverage average_a_, average_b_;

  void close() {
    average_a_.close(values_.a);
    average_b_.close(values_.b);
  }
};

PairedValues paired_values(PairedComparison& comparison, const Side& a, const Side& b,
                           const std::string& metric) {
  Pairing pairing(comparison, require_metric(*a.table, metric), require_metric(*b.table, metric));
  const std::vector<Key> left = keys_of(a), right = keys_of(b);
  std::size_t i = 0, j = 0;
  while (i < left.size() && j < right.size()) {
    if (left[i] < right[j]) {
      ++i;
    } else if (right[j] < left[i]) {
      ++j;
    } else {
      pairing.add(left[i++], right[j++]);
    }
  }
  const std::size_t partners = comparison.pairs + comparison.without_value;
  comparison.unpaired = left.size() + right.size() - 2 * partners;
  return pairing.values();
}

/// Within which differences are zero or tied.
double tolerance_of(const PairedValues& values) {
  return std::max(tie_tolerance(values.a.means), tie_tolerance(values.b.means));
}

std::vector<double> differences_of(const PairedValues& values) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < values.a.means.size(); ++i)
    differences.push_back(values.b.means[i] - values.a.means[i]);
  return differences;
}

void add_test(PairedComparison& comparison, const PairedValues& values,
              const std::vector<double>& differences) {
  using Test = PairedComparison::Test;
  const double tolerance = tolerance_of(values);
  for (const double d : differences) {
    ++(d > tolerance ? comparison.higher : d < -tolerance ? comparison.lower : comparison.equal);
  }
  if (comparison.column.info.is_rate() && values.a.one_run_each()) {
    comparison.test = Test::McNemarExact;
    comparison.p = mcnemar_exact(comparison.higher, comparison.lower);
    return;
  }
  const SignedRankTest test = signed_rank_test(differences, tolerance);
  comparison.test = test.exact ? Test::SignedRankExact : Test::SignedRankNormal;
  comparison.p = test.p;
}

Range difference_range(const Range& range) {
  return Range::between(range.low - range.high, range.high - range.low);
}

GroupSums singles(const std::vector<double>& values) {
  return {values, std::vector<double>(values.size(), 1.0)};
}

/// The interval of a side's mean over scenarios, of values with bounds that are not rates.
std::optional<Interval> side_interval(const QuantityInfo& info, const SideValues& values,
                                      double confidence) {
  if (info.kind != QuantityKind::Score)
    return gaffke_interval(moments_of(singles(values.means)), singles(values.means), info.range,
                           confidence);
  // All scenarios count alike, as if each had the mean number of runs.
  const double scenarios = static_cast<double>(values.means.size()),
               size = static_cast<double>(values.runs) / scenarios;
  GroupSums groups = singles(values.means);
  std::vector<double> positives = values.successes;
  for (std::size_t i = 0; i < groups.groups(); ++i) {
    groups.sums[i] *= size;
    groups.sizes[i] = size;
    positives[i] *= size;
  }
  return hurdle_interval(score_moments(groups, positives), info.range.high, confidence);
}

void add_difference_of_sides(PairedComparison& comparison, const SideValues& a, const SideValues& b,
                             double correlation, double confidence) {
  const QuantityInfo& info = comparison.column.info;
  const auto of_a = side_interval(info, a, confidence), of_b = side_interval(info, b, confidence);
  if (!of_a || !of_b) return;
  comparison.interval = clip_to_range(
      difference_range(info.range), *comparison.difference,
      difference_interval(*comparison.mean_b, *of_b, *comparison.mean_a, *of_a, correlation));
}

/// The natural logarithms of the values; none if one is not positive.
std::optional<std::vector<double>> logarithms(std::vector<double> values) {
  for (double& value : values) {
    if (!(value > 0)) return std::nullopt;
    value = std::log(value);
  }
  return values;
}

/// The ratio of geometric means, of positive values without an upper bound: t of its logarithm.
void add_ratio(PairedComparison& comparison, const SideValues& a, const SideValues& b,
               double confidence) {
  if (!states_median(comparison.column.info)) return;
  const auto log_a = logarithms(a.means), log_b = logarithms(b.means);
  if (!log_a || !log_b) return;
  comparison.ratio = std::exp(mean(*log_b) - mean(*log_a));
  std::optional<Interval> interval;
  if (comparison.is_unpaired) {
    interval = welch_interval(*log_b, *log_a, confidence);
  } else {
    std::vector<double> differences = *log_b;
    for (std::size_t i = 0; i < differences.size(); ++i) differences[i] -= (*log_a)[i];
    interval = t_interval(singles(differences), confidence);
  }
  if (interval)
    comparison.ratio_interval = Interval{std::exp(interval->low), std::exp(interval->high)};
}

void add_effect(PairedComparison& comparison, const PairedValues& values,
                const std::vector<double>& differences, double confidence) {
  const std::vector<double>&a = values.a.means, &b = values.b.means;
  const QuantityInfo& info = comparison.column.info;
  comparison.mean_a = mean(a);
  comparison.mean_b = mean(b);
  comparison.difference = mean(differences);
  comparison.superiority = probability_of_superiority(b, a);
  if (info.is_rate()) {
    comparison.interval = paired_rate_interval(b, a, confidence);
    return;
  }
  comparison.shift = hodges_lehmann(differences, confidence);
  add_ratio(comparison, values.a, values.b, confidence);
  if (!info.range.is_bounded()) return;
  if (info.kind == QuantityKind::Score) {
    add_difference_of_sides(comparison, values.a, values.b, paired_correlation(a, b), confidence);
  } else if (is_within(info.range, *comparison.mean_a) &&
             is_within(info.range, *comparison.mean_b)) {
    comparison.interval = gaffke_interval(moments_of(singles(differences)), singles(differences),
                                          difference_range(info.range), confidence);
  }
}

double relevant_difference(const PairedComparison& comparison, const ComparisonOptions& options) {
  if (options.relevant) return *options.relevant;
  if (comparison.column.info.is_rate()) return 0.05;
  return 0.05 * (std::abs(*comparison.mean_a) + std::abs(*comparison.mean_b)) / 2;
}

/// Standard deviation of the differences, for sample size planning. For rates half a discordant
/// scenario is added in each direction, so that it is positive without discordant scenarios.
double planning_deviation(const PairedComparison& comparison,
                          const std::vector<double>& differences) {
  if (!comparison.column.info.is_rate()) return standard_deviation(differences).value_or(0);
  double squares = 1;
  for (const double d : differences) squares += d * d;
  return std::sqrt(squares / static_cast<double>(differences.size() + 1));
}

/// `deviation` is that of a difference, `smallest` the number with which the tests can reject.
void add_power(PairedComparison& comparison, double deviation, std::size_t smallest,
               const ComparisonOptions& options) {
  const double alpha = test_level(options.analysis.confidence);
  comparison.relevant = relevant_difference(comparison, options);
  comparison.required_scenarios = smallest;
  // Requires two scenarios, since one tells nothing about the deviation of values that are no
  // rates.
  const bool is_known = comparison.column.info.is_rate() || comparison.scenarios > 1;
  if (comparison.relevant <= 0 || !is_known) {
    comparison.required_scenarios = 0;
  } else if (deviation > 0) {
    const double pairs = static_cast<double>(
        required_pairs(comparison.relevant, deviation, alpha, comparison.power));
    const auto needed = static_cast<std::size_t>(std::ceil(pairs / kSignedRankEfficiency));
    comparison.required_scenarios = std::max(comparison.required_scenarios, needed);
  }
}

/// The sign of all differences in the deciding interval; 0 if it has both, or if there is none.
int interval_sign(const PairedComparison& comparison) {
  const DecidingInterval deciding = deciding_interval(comparison);
  if (!deciding.interval) return 0;
  return deciding.interval->low > deciding.null    ? 1
         : deciding.interval->high < deciding.null ? -1
                                                   : 0;
}

Verdict verdict_of(const PairedComparison& comparison) {
  if (comparison.other_settings) return Verdict::OtherSettings;
  if (comparison.identical) return Verdict::Identical;
  const bool rejects = comparison.adjusted_p <= test_level(comparison.confidence);
  const int sign = interval_sign(comparison);
  if (rejects != (sign != 0)) return Verdict::Unconfirmed;
  if (!rejects) {
    const bool enough =
        comparison.required_scenarios > 0 && comparison.scenarios >= comparison.required_scenarios;
    return enough ? Verdict::NoDifference : Verdict::NotEnough;
  }
  const Direction direction = comparison.column.info.direction;
  if (direction == Direction::None) return Verdict::Different;
  return (sign > 0) == (direction == Direction::Up) ? Verdict::Better : Verdict::Worse;
}

/// Corrects the p values of one family.
void finish_family(const std::vector<PairedComparison*>& family) {
  // No test if there is nothing to compare, or no difference in any pair.
  const auto tested = [](const PairedComparison& c) { return c.scenarios > 0 && !c.identical; };
  std::vector<double> p;
  for (const PairedComparison* comparison : family)
    if (tested(*comparison)) p.push_back(comparison->p);
  const std::vector<double> adjusted = holm_adjusted(p);
  std::size_t next = 0;
  for (PairedComparison* comparison : family) {
    if (tested(*comparison)) comparison->adjusted_p = adjusted[next++];
    comparison->family = p.size();
    comparison->verdict = verdict_of(*comparison);
  }
}

PairedComparison begin_comparison(const Side& a, const Side& b, const std::string& metric,
                                  const ComparisonOptions& options) {
  require_valid(options.analysis);
  PairedComparison comparison;
  comparison.a = a.name;
  comparison.b = b.name;
  comparison.column = resolve_columns(*a.table, {metric})[0];
  comparison.confidence = options.analysis.confidence;
  comparison.power = options.power;
  comparison.other_settings = a.table != b.table && !options.despite_settings &&
                              !task_differences(a.table->manifest, b.table->manifest).empty();
  return comparison;
}

/// Counts the runs without a partner, and those without a value.
SideValues values_of(const Side& side, const std::string& metric, PairedComparison& comparison) {
  const ValueColumn& column = require_metric(*side.table, metric);
  const std::uint32_t method = index_of_method(*side.table, side.method);
  std::vector<ScenarioAverage> averages(side.table->scenario_hashes.size());
  for (std::size_t run = 0; run < side.table->size(); ++run) {
    if (side.table->method[run] != method) continue;
    ++comparison.unpaired;
    if (column.is_na(run)) {
      ++comparison.runs_without_value;
    } else {
      averages[side.table->scenario[run]].add(column.number(run));
    }
  }
  SideValues values;
  for (ScenarioAverage& average : averages) average.close(values);
  return values;
}

void add_unpaired_effect(PairedComparison& comparison, const SideValues& a, const SideValues& b,
                         double confidence) {
  comparison.mean_a = mean(a.means);
  comparison.mean_b = mean(b.means);
  comparison.difference = *comparison.mean_b - *comparison.mean_a;
  comparison.superiority = probability_of_superiority(b.means, a.means);
  if (comparison.column.info.is_rate()) {
    comparison.interval = rate_difference_interval(
        *comparison.mean_b, static_cast<double>(b.means.size()), *comparison.mean_a,
        static_cast<double>(a.means.size()), 0, confidence);
    return;
  }
  comparison.shift = rank_sum_shift(b.means, a.means, confidence);
  add_ratio(comparison, a, b, confidence);
  if (comparison.column.info.range.is_bounded())
    add_difference_of_sides(comparison, a, b, 0, confidence);
}

void add_unpaired_test(PairedComparison& comparison, const SideValues& a, const SideValues& b) {
  using Test = PairedComparison::Test;
  if (comparison.column.info.is_rate() && a.one_run_each() && b.one_run_each()) {
    const auto ones = [](const std::vector<double>& bits) {
      return static_cast<std::size_t>(std::count(bits.begin(), bits.end(), 1.0));
    };
    comparison.test = Test::FisherExact;
    comparison.p = fisher_exact(ones(a.means), a.means.size(), ones(b.means), b.means.size());
    return;
  }
  const RankSumTest test = rank_sum_test(b.means, a.means);
  comparison.test = test.exact ? Test::RankSumExact : Test::RankSumNormal;
  comparison.p = test.p;
}

/// Standard deviation of the difference of one scenario of each side, for sample size planning. A
/// rate has half a success and half a failure more, so that it is positive.
double unpaired_deviation(const PairedComparison& comparison, const std::vector<double>& a,
                          const std::vector<double>& b) {
  const bool is_rate = comparison.column.info.is_rate();
  const auto variance = [is_rate](const std::vector<double>& values) {
    const double n = static_cast<double>(values.size());
    const double rate = (mean(values) * n + 0.5) / (n + 1);
    const double deviation =
        is_rate ? std::sqrt(rate * (1 - rate)) : standard_deviation(values).value_or(0);
    return deviation * deviation;
  };
  return std::sqrt(variance(a) + variance(b));
}

}  // namespace

PairedComparison compare_pair(const Side& a, const Side& b, const std::string& metric,
                              const ComparisonOptions& options) {
  PairedComparison comparison = begin_comparison(a, b, metric, options);
  const PairedValues values = paired_values(comparison, a, b, metric);
  comparison.scenarios = values.a.means.size();
  if (values.a.means.empty()) return comparison;
  const std::vector<double> differences = differences_of(values);
  comparison.identical = values.identical;
  add_effect(comparison, values, differences, options.analysis.confidence);
  add_test(comparison, values, differences);
  add_power(comparison, planning_deviation(comparison, differences),
            min_pairs(test_level(options.analysis.confidence)), options);
  comparison.adjusted_p = comparison.p;
  comparison.verdict = verdict_of(comparison);
  return comparison;
}

PairedComparison compare_unpaired(const Side& a, const Side& b, const std::string& metric,
                                  const ComparisonOptions& options) {
  PairedComparison comparison = begin_comparison(a, b, metric, options);
  comparison.is_unpaired = true;
  const SideValues left = values_of(a, metric, comparison);
  const SideValues right = values_of(b, metric, comparison);
  comparison.scenarios_a = left.means.size();
  comparison.scenarios_b = right.means.size();
  comparison.scenarios = std::min(left.means.size(), right.means.size());
  if (comparison.scenarios == 0) return comparison;
  add_unpaired_effect(comparison, left, right, options.analysis.confidence);
  add_unpaired_test(comparison, left, right);
  add_power(comparison, unpaired_deviation(comparison, left.means, right.means),
            min_per_sample(test_level(options.analysis.confidence)), options);
  comparison.adjusted_p = comparison.p;
  comparison.verdict = verdict_of(comparison);
  return comparison;
}

DecidingInterval deciding_interval(const PairedComparison& comparison) {
  const QuantityInfo& info = comparison.column.info;
  if (info.is_rate() || info.kind == QuantityKind::Score) return {comparison.interval, 0};
  if (comparison.ratio_interval) return {comparison.ratio_interval, 1};
  return {comparison.shift ? comparison.shift->interval : std::nullopt, 0};
}

void finish_families(std::vector<PairedComparison>& comparisons) {
  std::map<std::string, std::vector<PairedComparison*>> families;  // by metric
  for (PairedComparison& comparison : comparisons)
    families[comparison.column.info.id].push_back(&comparison);
  for (const auto& [metric, family] : families) finish_family(family);
}

}  // namespace slalom
