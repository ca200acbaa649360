// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/quantile.h>
#include <slalom/statistics/statistics.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double count(const GroupSums& groups) {
  return sum(groups.sizes);
}

}  // namespace

double variance_of_mean(const GroupMoments& groups) {
  const double k = groups.groups, n = groups.values;
  return k / (k - 1) * groups.residuals / (n * n);
}

double test_level(double confidence) {
  const double level = 1 - confidence, rounded = std::round(level * 1e12) / 1e12;
  return rounded > 0 ? rounded : level;
}

double quantile(const std::vector<double>& sorted, double fraction) {
  const double position = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (position - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double mean(const std::vector<double>& values) {
  return sum(values) / static_cast<double>(values.size());
}

GroupSums sums_of(const ScenarioGroups& groups) {
  GroupSums result;
  for (const auto& group : groups) {
    result.sums.push_back(sum(group));
    result.sizes.push_back(static_cast<double>(group.size()));
  }
  return result;
}

double mean_of_groups(const GroupSums& groups) {
  return sum(groups.sums) / count(groups);
}

double median(std::vector<double> values) {
  return middle_values(std::move(values)).median;
}

double interquartile_mean(std::vector<double> values) {
  return middle_values(std::move(values)).interquartile_mean;
}

MiddleValues middle_values(std::vector<double> values) {
  const std::size_t size = values.size(), first = size / 4, last = (3 * size + 3) / 4 - 1;
  const auto at = [&values](std::size_t position) {
    return values.begin() + static_cast<std::ptrdiff_t>(position);
  };
  // Moves the order statistics first .. last to their positions, then the median.
  std::nth_element(at(0), at(first), values.end());
  if (last > first) std::nth_element(at(first + 1), at(last), values.end());
  if (size / 2 > first) std::nth_element(at(first + 1), at(size / 2), at(last));
  const double upper = values[size / 2];
  const bool odd = size % 2 == 1;
  const double lower = odd ? upper : *std::max_element(at(first), at(size / 2));
  // Value i covers the segment [i, i + 1]; the part within [n / 4, 3 n / 4] is its weight.
  const double n = static_cast<double>(size);
  const double first_weight = std::min(static_cast<double>(first + 1), 0.75 * n) - 0.25 * n;
  double total = first_weight * values[first];
  for (std::size_t i = first + 1; i < last; ++i) total += values[i];
  if (last > first) total += (0.75 * n - static_cast<double>(last)) * values[last];
  return {(lower + upper) / 2, total / (0.5 * n)};
}

std::optional<double> standard_deviation(const std::vector<double>& values) {
  if (values.size() < 2) return std::nullopt;
  const double m = mean(values);
  double squares = 0;
  for (const double value : values) squares += (value - m) * (value - m);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

Interval wilson_interval(double rate, double n, double confidence) {
  const double z = distributions::normal_quantile(0.5 + confidence / 2);
  const double shrink = 1 + z * z / n;
  const double center = (rate + z * z / (2 * n)) / shrink;
  const double half = z / shrink * std::sqrt(rate * (1 - rate) / n + z * z / (4 * n * n));
  // Rates of 0 and 1 have exact bounds; avoid rounding errors.
  return {rate == 0 ? 0.0 : std::max(0.0, center - half),
          rate == 1 ? 1.0 : std::min(1.0, center + half)};
}

Interval clopper_pearson_interval(double successes, double n, double confidence) {
  const double tail = (1 - confidence) / 2;
  return {successes <= 0 ? 0 : distributions::binomial_lower_bound(successes, n, tail),
          successes >= n ? 1 : distributions::binomial_upper_bound(successes, n, tail)};
}

GroupMoments moments_of(const GroupSums& groups) {
  GroupMoments moments{static_cast<double>(groups.groups()), count(groups), mean_of_groups(groups),
                       0};
  for (std::size_t i = 0; i < groups.groups(); ++i) {
    const double residual = groups.sums[i] - moments.mean * groups.sizes[i];
    moments.residuals += residual * residual;
  }
  return moments;
}

double effective_sample_size(const GroupMoments& groups) {
  const double k = groups.groups, n = groups.values, rate = groups.mean;
  if (k == n || k < 2) return k;
  const double between = variance_of_mean(groups);
  if (rate <= 0 || rate >= 1) return k;
  if (between <= 0) return n;
  return std::clamp(rate * (1 - rate) / between, k, n);
}

double effective_sample_size(const GroupSums& groups) {
  return effective_sample_size(moments_of(groups));
}

double runs_of_rate(const GroupMoments& groups, double confidence) {
  const double k = groups.groups, n = groups.values, runs = effective_sample_size(groups);
  if (k < 2 || k >= n) return runs;
  const auto quantile_of = [confidence](double freedom) {
    return distributions::students_t_quantile(0.5 + confidence / 2, freedom);
  };
  const double ratio = quantile_of(n - 1) / quantile_of(k - 1);
  return std::max(k, runs * ratio * ratio);
}

Interval rate_interval(const GroupMoments& groups, double confidence) {
  return wilson_interval(groups.mean, runs_of_rate(groups, confidence), confidence);
}

std::optional<Interval> t_interval(const GroupMoments& groups, double confidence) {
  if (groups.groups < 2 || groups.residuals <= 0) return std::nullopt;
  const double half = distributions::students_t_quantile(0.5 + confidence / 2, groups.groups - 1) *
                      std::sqrt(variance_of_mean(groups));
  return Interval{groups.mean - half, groups.mean + half};
}

std::optional<Interval> t_interval(const GroupSums& groups, double confidence) {
  return t_interval(moments_of(groups), confidence);
}

Interval percentile_interval(std::vector<double> estimates, double confidence) {
  std::sort(estimates.begin(), estimates.end());
  return {quantile(estimates, 0.5 - confidence / 2), quantile(estimates, 0.5 + confidence / 2)};
}

bool is_within(const Range& range, double value) {
  constexpr double kRounding = 1e-9;
  const double within = std::clamp(value, range.low, range.high);
  return std::abs(within - value) <= kRounding * std::max(1.0, std::abs(within));
}

Interval clip_to_range(const Range& range, double estimate, Interval interval) {
  if (!is_within(range, estimate)) return interval;
  return {std::clamp(interval.low, range.low, range.high),
          std::clamp(interval.high, range.low, range.high)};
}

}  // namespace slalom
