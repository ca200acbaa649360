// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/mean_interval.h>
#include <slalom/statistics/paired_rates.h>
#include <slalom/statistics/rank_statistics.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {

double mcnemar_exact(std::size_t only_a, std::size_t only_b) {
  const double n = static_cast<double>(only_a + only_b);
  if (n == 0) return 1;
  const double fewer = static_cast<double>(std::min(only_a, only_b));
  return std::min(1.0, 2 * distributions::binomial_cdf(fewer, n, 0.5));
}

Interval rate_difference_interval(double rate_a, double n_a, double rate_b, double n_b, double phi,
                                  double confidence) {
  const Interval a = wilson_interval(rate_a, n_a, confidence);
  const Interval b = wilson_interval(rate_b, n_b, confidence);
  return clip_to_range(Range::between(-1, 1), rate_a - rate_b,
                       difference_interval(rate_a, a, rate_b, b, phi));
}

double paired_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr std::size_t kFewMeans = 6;
  const auto is_outcome = [](double value) { return value == 0 || value == 1; };
  const bool are_outcomes =
      std::all_of(a.begin(), a.end(), is_outcome) && std::all_of(b.begin(), b.end(), is_outcome);
  const double correlation = pearson(a, b).value_or(0);
  return are_outcomes || a.size() >= kFewMeans ? correlation : std::min(correlation, 0.0);
}

Interval paired_rate_interval(const std::vector<double>& a, const std::vector<double>& b,
                              double confidence) {
  const double n = static_cast<double>(a.size());
  return rate_difference_interval(mean(a), n, mean(b), n, paired_correlation(a, b), confidence);
}

std::vector<double> holm_adjusted(const std::vector<double>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&p](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double largest = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double factor = static_cast<double>(p.size() - i);
    largest = std::max(largest, std::min(1.0, factor * p[order[i]]));
    adjusted[order[i]] = largest;
  }
  return adjusted;
}

}  // namespace slalom
