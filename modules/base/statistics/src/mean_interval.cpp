// SPDX-License-Identifier: BSD-3-Clause
#include "square.h"

#include <slalom/statistics/distributions.h>
#include <slalom/statistics/mean_interval.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

/// sqrt(x^2 + y^2 + 2 r x y).
double combined(double x, double y, double correlation) {
  return std::sqrt(std::max(0.0, x * x + y * y + 2 * correlation * x * y));
}

double correlation_of(const ScoreMoments& moments) {
  const double squares = moments.success.residuals * moments.given.residuals;
  return squares > 0 ? std::clamp(moments.products / std::sqrt(squares), -1.0, 1.0) : 0;
}

/// The probability that sum E_i terms_i > 0, of independent exponential variables E_i.
double probability_above_zero(const std::vector<double>& terms) {
  constexpr double kEdge = 1e-10, kNoTilt = 1e-5;
  const auto [least, greatest] = std::minmax_element(terms.begin(), terms.end());
  if (*least >= 0) return 1;
  if (*greatest <= 0) return 0;
  // The derivative of the cumulant generating function K(s) = -sum log(1 - s terms_i).
  const auto derivative = [&terms](double s) {
    double sum = 0;
    for (const double term : terms) sum += term / (1 - s * term);
    return sum;
  };
  const double low = (1 - kEdge) / *least, high = (1 - kEdge) / *greatest;
  if (derivative(low) >= 0) return 1;
  if (derivative(high) <= 0) return 0;
  const double s = distributions::find_root(derivative, low, high);
  double cumulant = 0, curvature = 0;
  for (const double term : terms) {
    cumulant -= std::log1p(-s * term);
    curvature += square(term / (1 - s * term));
  }
  const double w = std::copysign(std::sqrt(std::max(0.0, -2 * cumulant)), s);
  const double u = s * std::sqrt(curvature);
  if (std::abs(w) < kNoTilt || std::abs(u) < kNoTilt) return 0.5;
  const double density = std::exp(-w * w / 2) / std::sqrt(2 * M_PI);
  return distributions::normal_survival(w) + density * (1 / u - 1 / w);
}

/// The bound that the mean of values up to `high` exceeds with the probability `tail`.
double upper_bound(const GroupSums& groups, double high, double tail) {
  const double largest = *std::max_element(groups.sizes.begin(), groups.sizes.end());
  double least = high;
  for (std::size_t i = 0; i < groups.groups(); ++i)
    least = std::min(least, groups.sums[i] / groups.sizes[i]);
  if (least >= high) return high;
  std::vector<double> terms(groups.groups() + 1);
  const auto excess = [&](double bound) {
    for (std::size_t i = 0; i < groups.groups(); ++i)
      terms[i] = groups.sums[i] - bound * groups.sizes[i];
    terms.back() = largest * (high - bound);
    return tail - probability_above_zero(terms);
  };
  return std::min(high, distributions::find_root(excess, least, high));
}

/// The same, if the weighted sum were normal.
double normal_upper_bound(const GroupMoments& moments, double high, double tail) {
  const double size = moments.values / moments.groups, values = moments.values + size;
  const double center = (moments.values * moments.mean + size * high) / values;
  const double residuals = moments.residuals +
                           square(moments.mean - center) * moments.values * size +
                           square(size * (high - center));
  return std::min(high, center - distributions::normal_quantile(tail) *
                                     std::sqrt(residuals / (values * (values + size))));
}

/// The groups with values of the opposite sign.
GroupSums negated(GroupSums groups) {
  for (double& sum : groups.sums) sum = -sum;
  return groups;
}

/// The effective number of the values that are at most their median, in groups of `sizes`.
double effective_values(const std::vector<double>& values, const std::vector<std::size_t>& sizes,
                        double confidence) {
  const double middle = median(values);
  GroupSums below;
  std::size_t next = 0;
  for (const std::size_t size : sizes) {
    double sum = 0;
    for (std::size_t i = 0; i < size; ++i) sum += values[next++] <= middle ? 1 : 0;
    below.sums.push_back(sum);
    below.sizes.push_back(static_cast<double>(size));
  }
  return runs_of_rate(moments_of(below), confidence);
}

}  // namespace

ScoreMoments score_moments(const GroupSums& groups, const std::vector<double>& positives) {
  ScoreMoments moments;
  moments.success = moments_of({positives, groups.sizes});
  GroupSums given;
  for (std::size_t i = 0; i < groups.groups(); ++i) {
    if (positives[i] <= 0) continue;
    given.sums.push_back(groups.sums[i]);
    given.sizes.push_back(positives[i]);
  }
  if (given.groups() == 0) return moments;
  moments.given = moments_of(given);
  for (std::size_t i = 0; i < groups.groups(); ++i)
    moments.products += (positives[i] - moments.success.mean * groups.sizes[i]) *
                        (groups.sums[i] - moments.given.mean * positives[i]);
  return moments;
}

Interval hurdle_interval(const ScoreMoments& moments, double high, double confidence) {
  const double rate = moments.success.mean, given = moments.given.mean, mean = rate * given;
  if (moments.given.groups < 2) {
    const double scenarios = moments.success.groups;
    const Interval part = clopper_pearson_interval(std::clamp(mean / high, 0.0, 1.0) * scenarios,
                                                   scenarios, confidence);
    return {high * part.low, high * part.high};
  }
  const Interval of_rate = rate_interval(moments.success, confidence);
  Interval of_given = t_interval(moments.given, confidence).value_or(Interval{given, given});
  of_given.high =
      std::max(of_given.high, normal_upper_bound(moments.given, high, (1 - confidence) / 2));
  const double r = correlation_of(moments);
  const double below = combined(given * (rate - of_rate.low), rate * (given - of_given.low), r),
               above = combined(given * (of_rate.high - rate), rate * (of_given.high - given), r);
  return clip_to_range(Range::between(0, high), mean, {mean - below, mean + above});
}

std::optional<Interval> gaffke_interval(const GroupMoments& moments, const GroupSums& groups,
                                        const Range& range, double confidence) {
  const double tail = (1 - confidence) / 2;
  if (!is_within(range, moments.mean)) return std::nullopt;
  if (groups.groups() == 0) {
    GroupMoments opposite = moments;
    opposite.mean = -moments.mean;
    return Interval{-normal_upper_bound(opposite, -range.low, tail),
                    normal_upper_bound(moments, range.high, tail)};
  }
  for (std::size_t i = 0; i < groups.groups(); ++i)
    if (!is_within(range, groups.sums[i] / groups.sizes[i])) return std::nullopt;
  return Interval{-upper_bound(negated(groups), -range.low, tail),
                  upper_bound(groups, range.high, tail)};
}

std::optional<Interval> median_interval(const std::vector<double>& values,
                                        const std::vector<std::size_t>& sizes, double confidence) {
  if (values.empty()) return std::nullopt;
  const double n = static_cast<double>(values.size());
  const double effective =
      sizes.size() == values.size() ? n : std::floor(effective_values(values, sizes, confidence));
  double rank = 0;  // of the lower end; P(fewer than `rank` values below the median) <= tail
  while (rank < effective / 2 &&
         distributions::binomial_cdf(rank, effective, 0.5) <= (1 - confidence) / 2)
    ++rank;
  if (rank == 0) return std::nullopt;
  const auto lower = static_cast<std::ptrdiff_t>(std::max(1.0, std::floor(rank * n / effective)));
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  if (sorted.front() == sorted.back()) return std::nullopt;
  return Interval{sorted.begin()[lower - 1], sorted.end()[-lower]};
}

Interval difference_interval(double a, const Interval& of_a, double b, const Interval& of_b,
                             double correlation) {
  const double difference = a - b;
  return {difference - combined(a - of_a.low, of_b.high - b, -correlation),
          difference + combined(of_a.high - a, b - of_b.low, -correlation)};
}

std::string missing_bound(const Range& range) {
  if (range.is_bounded()) return "";
  if (range.bounded_below()) return "no upper bound";
  return range.bounded_above() ? "no lower bound" : "no bounds";
}

}  // namespace slalom
