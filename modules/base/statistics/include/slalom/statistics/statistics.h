// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/range.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// low <= high.
struct Interval {
  double low = 0;
  double high = 0;

  bool overlaps(const Interval& other) const { return low <= other.high && other.low <= high; }
};

/// Values of runs grouped by scenario: runs of one scenario are not independent of each other.
using ScenarioGroups = std::vector<std::vector<double>>;

/// Cells keep the sums of their scenarios up to this number, for statistics of single scenarios.
constexpr std::size_t kMaxKeptScenarios = 500;

/// Sufficient statistics of such groups for means.
struct GroupSums {
  std::vector<double> sums, sizes;  ///< one per scenario

  std::size_t groups() const { return sums.size(); }
};
GroupSums sums_of(const ScenarioGroups& groups);

/// Moments on which the variance of the mean over all values of groups depends.
struct GroupMoments {
  double groups = 0, values = 0;  ///< their numbers
  double mean = 0;                ///< over all values
  double residuals = 0;           ///< sum over groups of (sum - mean size)^2
};
GroupMoments moments_of(const GroupSums& groups);  ///< requires at least one value
/// Variance of the mean over all values, from the variation between groups; requires two.
double variance_of_mean(const GroupMoments& groups);

/// The level of tests that goes with a confidence: 0.05 with 0.95, where the difference of the two
/// doubles would be 0.050000000000000044.
double test_level(double confidence);

double mean(const std::vector<double>& values);  ///< requires at least one value
double median(std::vector<double> values);       ///< requires at least one value
/// Mean of the middle half of the values, with fractional weights at its edges; requires at least
/// one value.
double interquartile_mean(std::vector<double> values);
/// Computes both by selection instead of sorting; requires at least one value.
struct MiddleValues {
  double median = 0, interquartile_mean = 0;
};
MiddleValues middle_values(std::vector<double> values);
double mean_of_groups(const GroupSums& groups);  ///< over all values; requires at least one

/// Sample standard deviation (n - 1); none for fewer than two values.
std::optional<double> standard_deviation(const std::vector<double>& values);

/// Score interval of a rate `rate` observed in `n` trials (Wilson 1927). `n` need not be an
/// integer: see effective_sample_size. Requires 0 <= rate <= 1, n > 0, 0 < confidence < 1.
Interval wilson_interval(double rate, double n, double confidence);

/// Exact interval of a rate (Clopper and Pearson 1934): it covers with at least the confidence at
/// every rate. Neither number need be an integer. Requires 0 <= successes <= n, n > 0.
Interval clopper_pearson_interval(double successes, double n, double confidence);

/// Effective number of independent runs of the 0/1 values of `groups` (Kish's design effect, the
/// ratio of the between-scenario variance of the rate to the binomial one). n if each scenario has
/// one run; at least the number of scenarios, and equal to it if all values are equal.
double effective_sample_size(const GroupMoments& groups);
double effective_sample_size(const GroupSums& groups);

/// The number of runs of rate_interval(): the effective sample size. If scenarios have several runs
/// it is reduced by (t(n - 1) / t(k - 1))^2, the ratio of the quantiles of Student's t (Korn and
/// Graubard 1998, Survey Methodology 24), since the variance between scenarios is itself estimated
/// from k scenarios; at least k. Requires at least one value.
double runs_of_rate(const GroupMoments& groups, double confidence);

/// Interval of the rate of the 0/1 values of `groups`: Wilson's for that number of runs. It covers
/// with the confidence on average over rates; near 0 and 1 also with less.
Interval rate_interval(const GroupMoments& groups, double confidence);

/// Student's t interval of the mean over all values with the cluster-robust standard error (k
/// groups, k - 1 degrees of freedom; the usual interval if each group has one value). None for
/// fewer than two groups, and for groups without variation, which show no error.
std::optional<Interval> t_interval(const GroupMoments& groups, double confidence);
std::optional<Interval> t_interval(const GroupSums& groups, double confidence);

/// The interval between the two percentiles of bootstrap estimates that hold `confidence` of them;
/// requires at least one estimate.
Interval percentile_interval(std::vector<double> estimates, double confidence);

/// Whether a value is in the range, apart from rounding errors.
bool is_within(const Range& range, double value);

/// The part of the interval of an estimate within the range of the quantity. An estimate outside
/// the range, by more than rounding errors, is of another definition, of a foreign table: its
/// interval is left as it is.
Interval clip_to_range(const Range& range, double estimate, Interval interval);

}  // namespace slalom
