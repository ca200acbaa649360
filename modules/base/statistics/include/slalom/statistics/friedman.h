// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace slalom {

/// Friedman's test of methods ranked within each scenario.
struct FriedmanTest {
  std::size_t scenarios = 0;
  std::vector<double> mean_ranks;  ///< by method; 1 is best
  double chi_squared = 0;          ///< Friedman (1937), corrected for ties
  double p = 1;                    ///< of chi_squared with k - 1 degrees of freedom
  double iman_davenport_f = 0;     ///< Iman and Davenport (1980); infinite if all rankings agree
  double iman_davenport_p = 1;     ///< with k - 1 and (k - 1)(n - 1) degrees of freedom
  double critical_difference = 0;  ///< of mean ranks (Nemenyi 1963)
  /// Methods (indexes, best first) whose mean ranks differ by at most the critical difference: the
  /// bars of a critical-difference diagram (Demsar 2006). Only maximal groups, of two or more.
  std::vector<std::vector<std::size_t>> groups;
};

/// `values[scenario][method]`, without missing values; at least two methods and two scenarios. If
/// `more_is_better`, the largest value has rank 1; values within tie_tolerance() of the scenario
/// are tied. `alpha`: level of the critical difference.
FriedmanTest friedman_test(const std::vector<std::vector<double>>& values, bool more_is_better,
                           double alpha);

/// The upper `alpha` point of the range of k independent standard normal variables (studentized
/// range with infinitely many degrees of freedom).
double studentized_range_quantile(double alpha, std::size_t k);

}  // namespace slalom
