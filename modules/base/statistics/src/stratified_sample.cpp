// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/stratified_sample.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

/// The rate by Laplace's rule, which is neither 0 nor 1.
double cautious_rate(double successes, std::size_t n) {
  return (successes + 1) / (static_cast<double>(n) + 2);
}

/// Fisher and Yates' shuffle: std::shuffle differs between libraries.
void shuffle(std::vector<std::size_t>& indexes, RandomEngine& engine) {
  for (std::size_t i = indexes.size(); i > 1; --i) {
    const int other = uniform_int(engine, 0, static_cast<int>(i) - 1);
    std::swap(indexes[i - 1], indexes[static_cast<std::size_t>(other)]);
  }
}

double population_of(const Strata& strata) {
  std::size_t total = 0;
  for (const auto& stratum : strata) total += stratum.size();
  return static_cast<double>(total);
}

}  // namespace

Strata make_strata(const std::vector<double>& values, std::size_t strata, RandomEngine& engine) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  shuffle(order, engine);
  std::stable_sort(order.begin(), order.end(),
                   [&values](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  const std::size_t number = std::min(strata, values.size());
  Strata result(number);
  for (std::size_t i = 0; i < order.size(); ++i)
    result[i * number / order.size()].push_back(order[i]);
  // A second order, independent of the first one: that has decided which of equal values are here.
  for (auto& stratum : result) shuffle(stratum, engine);
  return result;
}

/// Adds scenarios one by one to the stratum that is furthest from its share.
Allocation proportional_allocation(const Strata& strata, std::size_t n) {
  Allocation allocation(strata.size(), 1);
  for (std::size_t total = strata.size(); total < n; ++total) {
    std::size_t best = strata.size();
    double largest = -1;
    for (std::size_t i = 0; i < strata.size(); ++i) {
      const double need =
          static_cast<double>(strata[i].size()) / (static_cast<double>(allocation[i]) + 0.5);
      if (allocation[i] >= strata[i].size() || need <= largest) continue;
      largest = need;
      best = i;
    }
    if (best == strata.size()) break;
    ++allocation[best];
  }
  return allocation;
}

StratifiedRate stratified_rate(const Strata& strata, const Allocation& sampled,
                               const std::vector<double>& successes, double confidence) {
  const double population = population_of(strata);
  StratifiedRate result;
  double variance = 0;
  for (std::size_t i = 0; i < strata.size(); ++i) {
    const double size = static_cast<double>(strata[i].size()), k = static_cast<double>(sampled[i]);
    const double weight = size / population, rate = cautious_rate(successes[i], sampled[i]);
    result.rate += weight * successes[i] / k;
    variance += weight * weight * rate * (1 - rate) / k * (1 - k / size);
  }
  const double half =
      std::sqrt(variance) * distributions::normal_quantile(1 - test_level(confidence) / 2);
  result.interval = {std::max(0.0, result.rate - half), std::min(1.0, result.rate + half)};
  return result;
}

}  // namespace slalom
