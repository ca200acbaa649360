#include <slalom/analysis/statistics.h>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

constexpr std::size_t kFewestForBootstrap = 20;
constexpr std::size_t kMostForBootstrap = 500;

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

std::size_t count(const ScenarioGroups& groups) {
  std::size_t n = 0;
  for (const auto& group : groups) n += group.size();
  return n;
}

/// Variance of the mean over all values, estimated from the spread between groups.
double variance_of_mean(const ScenarioGroups& groups) {
  const double m = mean_of_groups(groups);
  double squares = 0;
  for (const auto& group : groups) {
    const double residual = sum(group) - m * static_cast<double>(group.size());
    squares += residual * residual;
  }
  const double k = static_cast<double>(groups.size()), n = static_cast<double>(count(groups));
  return k / (k - 1) * squares / (n * n);
}

/// Linear interpolation between the order statistics.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

double mean(const std::vector<double>& values) {
  return sum(values) / static_cast<double>(values.size());
}

double mean_of_groups(const ScenarioGroups& groups) {
  double total = 0;
  for (const auto& group : groups) total += sum(group);
  return total / static_cast<double>(count(groups));
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return quantile(values, 0.5);
}

double interquartile_mean(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  // Value i stands for the stretch [i, i + 1] of n; what lies in [n / 4, 3 n / 4] counts.
  const double n = static_cast<double>(values.size());
  double total = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double place = static_cast<double>(i);
    const double share = std::min(place + 1, 0.75 * n) - std::max(place, 0.25 * n);
    if (share > 0) total += share * values[i];
  }
  return total / (0.5 * n);
}

std::optional<double> standard_deviation(const std::vector<double>& values) {
  if (values.size() < 2) return std::nullopt;
  const double m = mean(values);
  double squares = 0;
  for (const double value : values) squares += (value - m) * (value - m);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

Interval wilson_interval(double rate, double n, double confidence) {
  const double z = boost::math::quantile(boost::math::normal(), 0.5 + confidence / 2);
  const double shrink = 1 + z * z / n;
  const double centre = (rate + z * z / (2 * n)) / shrink;
  const double half = z / shrink * std::sqrt(rate * (1 - rate) / n + z * z / (4 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

double effective_sample_size(const ScenarioGroups& groups) {
  const double k = static_cast<double>(groups.size()), n = static_cast<double>(count(groups));
  if (k == n || k < 2) return k;
  const double rate = mean_of_groups(groups);
  const double between = variance_of_mean(groups);
  if (rate <= 0 || rate >= 1) return k;
  if (between <= 0) return n;
  return std::clamp(rate * (1 - rate) / between, k, n);
}

std::optional<Interval> t_interval(const ScenarioGroups& groups, double confidence) {
  if (groups.size() < 2) return std::nullopt;
  const boost::math::students_t distribution(static_cast<double>(groups.size() - 1));
  const double half = boost::math::quantile(distribution, 0.5 + confidence / 2) *
                      std::sqrt(variance_of_mean(groups));
  const double m = mean_of_groups(groups);
  return Interval{m - half, m + half};
}

std::optional<Interval> bootstrap_interval(const ScenarioGroups& groups, double confidence,
                                           RandomEngine& engine, int resamples) {
  if (groups.size() < 2) return std::nullopt;
  std::vector<double> sums, sizes, means;
  for (const auto& group : groups) {
    sums.push_back(sum(group));
    sizes.push_back(static_cast<double>(group.size()));
  }
  const int last = static_cast<int>(groups.size()) - 1;
  for (int resample = 0; resample < resamples; ++resample) {
    double total = 0, n = 0;
    for (int draw = 0; draw <= last; ++draw) {
      const auto chosen = static_cast<std::size_t>(uniform_int(engine, 0, last));
      total += sums[chosen];
      n += sizes[chosen];
    }
    means.push_back(total / n);
  }
  std::sort(means.begin(), means.end());
  return Interval{quantile(means, 0.5 - confidence / 2), quantile(means, 0.5 + confidence / 2)};
}

std::optional<Interval> mean_interval(const ScenarioGroups& groups, double confidence,
                                      RandomEngine& engine) {
  if (groups.size() < kFewestForBootstrap || groups.size() > kMostForBootstrap) {
    return t_interval(groups, confidence);
  }
  return bootstrap_interval(groups, confidence, engine);
}

}  // namespace slalom
