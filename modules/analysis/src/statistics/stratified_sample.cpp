// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/distributions.h>
#include <slalom/analysis/stratified_sample.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

/// The rate by Laplace's rule, which is neither 0 nor 1.
double cautious_rate(double successes, std::size_t n) {
  return (successes + 1) / (static_cast<double>(n) + 2);
}

std::size_t total_of(const Allocation& allocation) {
  return std::accumulate(allocation.begin(), allocation.end(), std::size_t{0});
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

/// Adds scenarios one by one where the wanted fraction is furthest from being reached.
Allocation fill(const Strata& strata, Allocation allocation, const std::vector<double>& wanted,
                std::size_t n) {
  for (std::size_t total = total_of(allocation); total < n; ++total) {
    std::size_t best = strata.size();
    double largest = -1;
    for (std::size_t i = 0; i < strata.size(); ++i) {
      const double need = wanted[i] / (static_cast<double>(allocation[i]) + 0.5);
      if (allocation[i] >= strata[i].size() || need <= largest) continue;
      largest = need;
      best = i;
    }
    if (best == strata.size()) break;
    ++allocation[best];
  }
  return allocation;
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

Allocation proportional_allocation(const Strata& strata, std::size_t n) {
  std::vector<double> sizes;
  for (const auto& stratum : strata) sizes.push_back(static_cast<double>(stratum.size()));
  return fill(strata, Allocation(strata.size(), 1), sizes, n);
}

Allocation neyman_allocation(const Strata& strata, const Allocation& first,
                             const std::vector<std::vector<std::size_t>>& successes,
                             std::size_t n) {
  std::vector<double> wanted;
  for (std::size_t i = 0; i < strata.size(); ++i) {
    double variance = 0;
    for (const auto& method : successes) {
      const double rate = cautious_rate(static_cast<double>(method[i]), first[i]);
      variance += rate * (1 - rate) / static_cast<double>(successes.size());
    }
    wanted.push_back(static_cast<double>(strata[i].size()) * std::sqrt(variance));
  }
  return fill(strata, first, wanted, n);
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
  const double half = std::sqrt(variance) * boost::math::quantile(distributions::Normal(0, 1),
                                                                  1 - test_level(confidence) / 2);
  result.interval = {std::max(0.0, result.rate - half), std::min(1.0, result.rate + half)};
  return result;
}

}  // namespace slalom
