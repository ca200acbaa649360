#pragma once

#include <slalom/analysis/statistics.h>

#include <cstddef>
#include <vector>

namespace slalom {

/// McNemar's exact conditional test of two paired rates, two-sided: `only_a` pairs in which only
/// the first succeeded, `only_b` in which only the second did (McNemar 1947; the binomial
/// distribution as in Fagerland, Lydersen and Laake 2013). 1 where no pair differs.
double mcnemar_exact(std::size_t only_a, std::size_t only_b);

/// Interval of rate_a - rate_b by "square and add" of two Wilson intervals (Newcombe 1998, method
/// 10), with the correlation `phi` between the two (his paired form; 0: independent samples).
/// Always within [-1, 1], and never of no width.
Interval rate_difference_interval(double rate_a, double n_a, double rate_b, double n_b, double phi,
                                  double confidence);

/// The same of paired rates, one a scenario in [0, 1] each: n is the number of scenarios, phi the
/// correlation of the two (0 where one is constant). Requires equal sizes, one pair at least.
Interval paired_rate_interval(const std::vector<double>& a, const std::vector<double>& b,
                              double confidence);

/// Holm's (1979) adjustment of the p values of one family: reject where the result is at most
/// alpha. In the order of `p`.
std::vector<double> holm_adjusted(const std::vector<double>& p);

}  // namespace slalom
