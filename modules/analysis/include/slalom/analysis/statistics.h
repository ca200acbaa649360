#pragma once

#include <slalom/core/random.h>

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

/// All that statistics of means need of such groups.
struct GroupSums {
  std::vector<double> sums, sizes;  ///< one a scenario

  std::size_t groups() const { return sums.size(); }
};
GroupSums sums_of(const ScenarioGroups& groups);

double mean(const std::vector<double>& values);  ///< requires at least one value
double median(std::vector<double> values);       ///< requires at least one value
/// Mean of the middle half of the values, those at its edges counted in part; requires one.
double interquartile_mean(std::vector<double> values);
/// Both at once, by selection rather than sorting; requires at least one value.
struct MiddleValues {
  double median = 0, interquartile_mean = 0;
};
MiddleValues middle_values(std::vector<double> values);
double mean_of_groups(const GroupSums& groups);  ///< over all values; requires one

/// Sample standard deviation (n - 1); none with fewer than two values.
std::optional<double> standard_deviation(const std::vector<double>& values);

/// Score interval of a rate `rate` seen in `n` trials (Wilson 1927). `n` need not be whole: see
/// effective_sample_size. Requires 0 <= rate <= 1, n > 0, 0 < confidence < 1.
Interval wilson_interval(double rate, double n, double confidence);

/// How many independent runs the 0/1 values of `groups` are worth (Kish's design effect, the ratio
/// of the between-scenario variance of the rate to the binomial one). All n of them where each
/// scenario was driven once; at least the number of scenarios, and just that where all values are
/// equal, because repetitions in one scenario then add nothing that can be told apart.
double effective_sample_size(const GroupSums& groups);

/// Student's t interval of the mean over all values with the standard error that allows for
/// dependence within a scenario (k groups, k - 1 degrees of freedom; the textbook interval where
/// each group has one value). None with fewer than two groups.
std::optional<Interval> t_interval(const GroupSums& groups, double confidence);

/// Percentile bootstrap interval of the mean over all values: scenarios are drawn with replacement,
/// each with all its runs, so it never leaves the range of the groups' means. None with fewer than
/// two groups.
std::optional<Interval> bootstrap_interval(const GroupSums& groups, double confidence,
                                           RandomEngine& engine, int resamples = 2000);

/// A bound that the quantity has by its definition: intervals do not leave it.
struct ValueRange {
  std::optional<double> low, high;
};
Interval within(const ValueRange& range, Interval interval);

/// The interval that tables show: bootstrap for 20 to 500 scenarios; the t interval below, where
/// the percentile bootstrap is known to be too narrow, and above, where both agree and it costs
/// nothing.
std::optional<Interval> mean_interval(const GroupSums& groups, double confidence,
                                      RandomEngine& engine);

}  // namespace slalom
