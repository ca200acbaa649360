// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/statistics/statistics.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Moments of the values of a score (QuantityKind::Score), which is 0 in runs that failed.
struct ScoreMoments {
  GroupMoments success;  ///< of 1 for each value that is not 0, and 0 for the others
  GroupMoments given;    ///< of the values that are not 0; the groups are those that have one
  double products = 0;   ///< sum over groups of the products of both residuals
};
/// `positives`: how many values of each group are not 0; fractions of equal sizes are allowed.
/// Requires at least one value.
ScoreMoments score_moments(const GroupSums& groups, const std::vector<double>& positives);

/// The interval of the mean of a score in [0, high]: mean = success rate x mean given success. The
/// MOVER method combines rate_interval() of the n values with the t interval of the k that are not
/// 0 (Zou and Donner 2008, Stat. Med. 27:1693; for zeros and a positive part Zou, Taleban and Huo
/// 2009, Comput. Stat. Data Anal. 53:3755). The correlation of both estimates, from repetitions of
/// scenarios, enters as in Newcombe's method 8. With fewer than two groups with a success it is
/// clopper_pearson_interval() of the sum of the values, in units of `high`. A standard deviation
/// cannot show a failure that has not occurred yet; the interval of the rate does. Nor can it show
/// a value near `high`: the upper end of the values that are not 0 is at least that of
/// gaffke_interval(), as if the weighted sum were normal.
Interval hurdle_interval(const ScoreMoments& moments, double high, double confidence);

/// The interval of the mean of values within the bounded `range`, of any distribution (Gaffke 2005;
/// Learned-Miller and Thomas 2019, arXiv 1905.06208). The upper end is the quantile of sum w_i x_i
/// over the values and the upper bound of the range, with weights w from the flat Dirichlet
/// distribution; the lower end likewise. Its coverage is conjectured, and confirmed in simulations.
///
/// The quantile is computed by a saddlepoint approximation (Lugannani and Rice 1980, Adv. Appl.
/// Prob. 12:475), without random numbers. Scenarios take the place of values, and the largest one
/// that of the bound. `groups` may be empty if there are more than kMaxKeptScenarios: then the
/// weighted sum counts as normal. None if a mean of a group is outside the range.
std::optional<Interval> gaffke_interval(const GroupMoments& moments, const GroupSums& groups,
                                        const Range& range, double confidence);

/// The interval of the median between two order statistics, by the binomial distribution (Thompson
/// 1936, Ann. Math. Stat. 7:122). `sizes` are the numbers of successive values that are of one
/// scenario: with repetitions the effective number of values is that of the rate of values below
/// the median (Woodruff 1952, J. Am. Stat. Assoc. 47:635). None for fewer values than the
/// confidence needs (6 for 0.95), and if all values are equal.
std::optional<Interval> median_interval(const std::vector<double>& values,
                                        const std::vector<std::size_t>& sizes, double confidence);

/// The interval of a - b from those of a and b, with the correlation of both estimates (MOVER-D,
/// Zou 2007, Psychol. Methods 12:399; of rates Newcombe 1998).
Interval difference_interval(double a, const Interval& of_a, double b, const Interval& of_b,
                             double correlation);

/// Why there is no interval of a mean of values in `range`: "no upper bound"; "" if it is bounded.
std::string missing_bound(const Range& range);

}  // namespace slalom
