// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/rank_statistics.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace slalom {
namespace {

bool constant(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
}

}  // namespace

double tie_tolerance(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return kTieTolerance * largest;
}

std::vector<double> midranks(const std::vector<double>& values, double tolerance) {
  const std::vector<std::size_t> order = ascending_order(values);
  std::vector<double> ranks(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    const double last = values[order[first]] + tolerance;
    while (end < order.size() && values[order[end]] <= last) ++end;
    // Ranks first + 1 .. end.
    const double shared = (static_cast<double>(first + 1) + static_cast<double>(end)) / 2;
    for (std::size_t i = first; i < end; ++i) ranks[order[i]] = shared;
    first = end;
  }
  return ranks;
}

double sum_of_tie_terms(const std::vector<double>& ranks) {
  std::map<double, double> sizes;
  for (const double rank : ranks) sizes[rank] += 1;
  double total = 0;
  for (const auto& [rank, t] : sizes) total += t * t * t - t;
  return total;
}

double probability_of_superiority(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> all = a;
  all.insert(all.end(), b.begin(), b.end());
  const std::vector<double> ranks = midranks(all, tie_tolerance(all));
  const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
  const double sum =
      std::accumulate(ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(a.size()), 0.0);
  return (sum - m * (m + 1) / 2) / (m * n);
}

std::optional<double> kendall_tau(const std::vector<double>& x, const std::vector<double>& y) {
  const auto order = [](double a, double b, double tolerance) {
    return a > b + tolerance ? 1 : b > a + tolerance ? -1 : 0;
  };
  const double tx = tie_tolerance(x), ty = tie_tolerance(y);
  double concordance = 0, untied_x = 0, untied_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = i + 1; j < x.size(); ++j) {
      const int a = order(x[i], x[j], tx), b = order(y[i], y[j], ty);
      concordance += a * b;
      untied_x += a * a;
      untied_y += b * b;
    }
  }
  if (untied_x == 0 || untied_y == 0) return std::nullopt;
  return concordance / std::sqrt(untied_x * untied_y);
}

std::vector<std::size_t> ascending_order(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}

std::optional<NoiseCeiling> noise_ceiling(std::vector<double> correlations, double confidence) {
  if (correlations.empty()) return std::nullopt;
  const double average = mean(correlations);
  return NoiseCeiling{average, percentile_interval(std::move(correlations), confidence)};
}

std::optional<double> pearson(const std::vector<double>& x, const std::vector<double>& y) {
  if (constant(x) || constant(y)) return std::nullopt;
  const double mx = mean(x), my = mean(y);
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mx) * (x[i] - mx);
    yy += (y[i] - my) * (y[i] - my);
    xy += (x[i] - mx) * (y[i] - my);
  }
  return std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0);
}

RankCorrelation spearman(const std::vector<double>& x, const std::vector<double>& y,
                         double confidence) {
  RankCorrelation result;
  result.n = x.size();
  if (result.n < 3 || constant(x) || constant(y)) return result;
  const double rho = *pearson(midranks(x), midranks(y));
  result.rho = rho;
  if (result.n < 4) return result;
  if (std::abs(rho) == 1) {
    result.interval = Interval{rho, rho};
    return result;
  }
  const double z = distributions::normal_quantile(0.5 + confidence / 2);
  const double half = z * std::sqrt((1 + rho * rho / 2) / static_cast<double>(result.n - 3));
  result.interval = Interval{std::tanh(std::atanh(rho) - half), std::tanh(std::atanh(rho) + half)};
  return result;
}

}  // namespace slalom
