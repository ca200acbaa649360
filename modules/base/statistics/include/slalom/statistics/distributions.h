// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

/// Boost's distributions, computed in double on all processors. By default Boost computes in long
/// double, which has 64 digits (of base 2) on x86-64 and 113, in software, on arm64. Boost's
/// headers are included by one source, since they take seconds to compile. Arguments outside the
/// domain throw std::domain_error. NAME_survival() is P(X > x), without loss of digits where it is
/// small.
namespace slalom::distributions {

double normal_quantile(double p);
double normal_survival(double x);

double students_t_quantile(double p, double freedom);
/// P(|X| > t) of a noncentral t distribution.
double noncentral_t_outside(double t, double freedom, double shift);

double chi_squared_quantile(double p, double freedom);
double chi_squared_survival(double x, double freedom);

double fisher_f_quantile(double p, double freedom_1, double freedom_2);
double fisher_f_survival(double x, double freedom_1, double freedom_2);

/// P(X <= successes) of n trials.
double binomial_cdf(double successes, double n, double rate);
double binomial_survival(double successes, double n, double rate);
/// The bounds of Clopper and Pearson (1934) of the rate, each with a probability `tail` of error.
double binomial_lower_bound(double successes, double n, double tail);
double binomial_upper_bound(double successes, double n, double tail);

/// The root of an increasing function between `low` and `high` (Alefeld, Potra and Shi 1995,
/// algorithm 748), to a relative error of 2^-43.
double find_root(const std::function<double(double)>& f, double low, double high);

}  // namespace slalom::distributions
