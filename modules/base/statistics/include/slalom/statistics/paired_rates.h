// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/statistics/statistics.h>

#include <cstddef>
#include <vector>

namespace slalom {

/// p value of McNemar's exact conditional test of two paired rates, two-sided: `only_a` pairs in
/// which only the first succeeded, `only_b` pairs in which only the second succeeded (McNemar 1947;
/// binomial distribution as in Fagerland, Lydersen and Laake 2013). 1 without discordant pairs.
double mcnemar_exact(std::size_t only_a, std::size_t only_b);

/// Interval of rate_a - rate_b by "square and add" of two Wilson intervals without continuity
/// correction, with the correlation `phi` between the two. phi = 0: independent samples, method 10
/// of Newcombe (1998, Stat. Med. 17:873-890). Otherwise paired samples with uncorrected phi, method
/// 8 of Newcombe (1998, Stat. Med. 17:2635-2650); method 10 of that paper uses a continuity
/// correction of phi. Always within [-1, 1], with nonzero width.
Interval rate_difference_interval(double rate_a, double n_a, double rate_b, double n_b, double phi,
                                  double confidence);

/// The correlation of paired values for the interval of their difference: Pearson's, 0 if one side
/// is constant, and at most 0 for fewer than six pairs of means, since a positive one makes the
/// interval narrow: that of two pairs is always 1 or -1.
double paired_correlation(const std::vector<double>& a, const std::vector<double>& b);

/// The same for paired rates in [0, 1], one per scenario: n is the number of scenarios, phi their
/// paired_correlation(). With one run per scenario it is Newcombe's paired
/// method 8. Requires equal sizes and at least one pair.
Interval paired_rate_interval(const std::vector<double>& a, const std::vector<double>& b,
                              double confidence);

/// Holm's (1979) adjustment of the p values of one family: reject if the result is at most
/// alpha. In the order of `p`.
std::vector<double> holm_adjusted(const std::vector<double>& p);

}  // namespace slalom
