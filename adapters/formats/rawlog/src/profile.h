// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/statistics/statistics.h>

#include <functional>

namespace slalom {

/// A parameter of a least-squares fit.
struct Profile {
  double best = 0;                 ///< with the smallest sum of squares
  double lowest = 0, highest = 0;  ///< the values that are considered
  double freedom = 1;              ///< degrees of freedom of the residuals
  /// The growth of the sum of squares, minimized over all other parameters, divided by the variance
  /// of the residuals.
  std::function<double(double)> deviance;
};

/// Adds the profiles of two independent fits with a common value of the parameter.
Profile pooled(const Profile& a, const Profile& b);

/// The values that an F test with 1 degree of freedom does not reject (profile likelihood: D. M.
/// Bates, D. G. Watts, "Nonlinear Regression Analysis and Its Applications", 1988, section 6.1). It
/// is not symmetric where the sum of squares is not, ends at a bound of the parameter, and contains
/// all values that are equally good. At a bound it holds the truth more often than `confidence`, up
/// to (1 + confidence) / 2.
Interval profile_interval(const Profile& profile, double confidence);

}  // namespace slalom
