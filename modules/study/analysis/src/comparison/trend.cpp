// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/trend.h>
#include <slalom/statistics/rank_statistics.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

TrendTest standardized(TrendTest::Kind kind, double statistic, double variance) {
  if (variance <= 0) return {};
  const double z = statistic / std::sqrt(variance);
  return {kind, z, std::erfc(std::abs(z) / std::sqrt(2))};
}

/// Values with the indexes of their groups, by value.
std::vector<std::pair<double, std::size_t>> sorted_with_group(
    const std::vector<std::vector<double>>& groups) {
  std::vector<std::pair<double, std::size_t>> all;
  for (std::size_t group = 0; group < groups.size(); ++group)
    for (const double value : groups[group]) all.emplace_back(value, group);
  std::sort(all.begin(), all.end());
  return all;
}

/// Sums over the sizes m of groups, or of ties, as the variance needs them.
struct SizeSums {
  double pairs = 0;     ///< m (m - 1)
  double weighted = 0;  ///< m (m - 1) (2 m + 5)
  double triples = 0;   ///< m (m - 1) (m - 2)

  void add(double m) {
    pairs += m * (m - 1);
    weighted += m * (m - 1) * (2 * m + 5);
    triples += m * (m - 1) * (m - 2);
  }
};

double jonckheere_variance(const SizeSums& all, const SizeSums& groups, const SizeSums& ties) {
  double variance = (all.weighted - groups.weighted - ties.weighted) / 72;
  if (all.triples > 0) variance += groups.triples * ties.triples / (36 * all.triples);
  if (all.pairs > 0) variance += groups.pairs * ties.pairs / (8 * all.pairs);
  return variance;
}

std::vector<double> scenario_means_of(const GroupSums& groups) {
  std::vector<double> means;
  for (std::size_t i = 0; i < groups.groups(); ++i)
    means.push_back(groups.sums[i] / groups.sizes[i]);
  return means;
}

TrendTest rate_trend(const std::vector<GroupMoments>& bins) {
  std::vector<double> successes, sizes;
  for (const GroupMoments& bin : bins) {
    sizes.push_back(effective_sample_size(bin));
    successes.push_back(bin.mean * sizes.back());
  }
  return cochran_armitage(successes, sizes);
}

}  // namespace

TrendTest cochran_armitage(const std::vector<double>& successes, const std::vector<double>& sizes) {
  double n = 0, x = 0, sn = 0, ssn = 0, sx = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double score = static_cast<double>(i);
    n += sizes[i];
    x += successes[i];
    sn += score * sizes[i];
    ssn += score * score * sizes[i];
    sx += score * successes[i];
  }
  if (n <= 0) return {};
  const double rate = x / n;
  return standardized(TrendTest::Kind::CochranArmitage, sx - rate * sn,
                      rate * (1 - rate) * (ssn - sn * sn / n));
}

TrendTest jonckheere_terpstra(const std::vector<std::vector<double>>& groups) {
  const auto values = sorted_with_group(groups);
  std::vector<double> magnitudes;
  for (const auto& [value, group] : values) magnitudes.push_back(value);
  const double tolerance = tie_tolerance(magnitudes);
  SizeSums sizes, ties, total;
  total.add(static_cast<double>(values.size()));
  for (const auto& group : groups) sizes.add(static_cast<double>(group.size()));
  // Pairs of values of different groups in the order of their groups, less those against it.
  double statistic = 0;
  std::vector<double> below(groups.size(), 0);
  for (std::size_t first = 0; first < values.size();) {
    std::size_t end = first;
    while (end < values.size() && values[end].first <= values[first].first + tolerance) ++end;
    for (std::size_t i = first; i < end; ++i)
      for (std::size_t group = 0; group < groups.size(); ++group)
        statistic += group < values[i].second   ? below[group]
                     : group > values[i].second ? -below[group]
                                                : 0;
    for (std::size_t i = first; i < end; ++i) ++below[values[i].second];
    ties.add(static_cast<double>(end - first));
    first = end;
  }
  // Jonckheere's statistic counts the pairs in order, half of this difference above its mean.
  return standardized(TrendTest::Kind::JonckheereTerpstra, statistic / 2,
                      jonckheere_variance(total, sizes, ties));
}

TrendTest linear_contrast(const std::vector<GroupMoments>& groups) {
  double used = 0, scores = 0;
  const auto is_used = [](const GroupMoments& group) { return group.groups >= 2; };
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (!is_used(groups[i])) continue;
    ++used;
    scores += static_cast<double>(i);
  }
  double contrast = 0, variance = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (!is_used(groups[i])) continue;
    const double score = static_cast<double>(i) - scores / used;
    contrast += score * groups[i].mean;
    variance += score * score * variance_of_mean(groups[i]);
  }
  return standardized(TrendTest::Kind::LinearContrast, contrast, variance);
}

std::optional<Trend> find_trend(const std::vector<CellSums>& bins, bool rate) {
  Trend trend;
  std::size_t large_bins = 0;
  bool has_all_groups = true;
  std::vector<GroupMoments> moments;
  std::vector<std::vector<double>> means;
  for (const CellSums& bin : bins) {
    if (bin.available() == 0) continue;
    moments.push_back(bin.moments());
    const auto scenarios = static_cast<std::size_t>(moments.back().groups);
    trend.scenarios += scenarios;
    ++trend.bins;
    large_bins += scenarios >= kMinScenariosOfBin ? 1 : 0;
    has_all_groups = has_all_groups && scenarios <= kMaxKeptScenarios;
    if (!rate) means.push_back(scenario_means_of(bin.groups()));
  }
  if (trend.scenarios < kMinScenariosOfTrend || large_bins < 2) return std::nullopt;
  trend.test = rate             ? rate_trend(moments)
               : has_all_groups ? jonckheere_terpstra(means)
                                : linear_contrast(moments);
  trend.adjusted_p = trend.test.p;
  return trend;
}

}  // namespace slalom
