// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/statistics/statistics.h>

#include <cstddef>
#include <vector>

namespace slalom {

/// Indexes of scenarios by stratum, each in random order: a sample is the first ones of each.
using Strata = std::vector<std::vector<std::size_t>>;

constexpr std::size_t kStrata = 8;

/// Strata of equal size, to one, between quantiles of `values`, such as predicted difficulties;
/// equal values are divided at random. As many as there are values, if these are fewer than
/// `strata`.
Strata make_strata(const std::vector<double>& values, std::size_t strata, RandomEngine& engine);

/// How many of each stratum are sampled.
using Allocation = std::vector<std::size_t>;

/// A sample of `n` in proportion to the sizes of the strata: at least one of each, at most all.
Allocation proportional_allocation(const Strata& strata, std::size_t n);

/// A rate over all scenarios, estimated from a sample.
struct StratifiedRate {
  double rate = 0;
  Interval interval;
};

/// The mean of the rates of the strata, weighted by their sizes (Cochran 1977, chapter 5). The
/// variance is that of the design, with the finite population correction; a stratum with s
/// successes of k, or fractions of them with the sum s, has the variance of the rate (s + 1) / (k +
/// 2), so that it is not 0 where all succeed. The interval is that of the normal distribution,
/// within [0, 1].
StratifiedRate stratified_rate(const Strata& strata, const Allocation& sampled,
                               const std::vector<double>& successes, double confidence);

}  // namespace slalom
