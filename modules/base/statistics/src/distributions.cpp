// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/statistics/distributions.h>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/roots.hpp>

#include <cstdint>

namespace slalom::distributions {
namespace {

using boost::math::complement;
using Double = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using Binomial = boost::math::binomial_distribution<double, Double>;
using ChiSquared = boost::math::chi_squared_distribution<double, Double>;
using FisherF = boost::math::fisher_f_distribution<double, Double>;
using NonCentralT = boost::math::non_central_t_distribution<double, Double>;
using Normal = boost::math::normal_distribution<double, Double>;
using StudentsT = boost::math::students_t_distribution<double, Double>;

}  // namespace

double normal_quantile(double p) {
  return quantile(Normal(), p);
}

double normal_survival(double x) {
  return cdf(complement(Normal(), x));
}

double students_t_quantile(double p, double freedom) {
  return quantile(StudentsT(freedom), p);
}

double noncentral_t_outside(double t, double freedom, double shift) {
  const NonCentralT shifted(freedom, shift);
  return cdf(complement(shifted, t)) + cdf(shifted, -t);
}

double chi_squared_quantile(double p, double freedom) {
  return quantile(ChiSquared(freedom), p);
}

double chi_squared_survival(double x, double freedom) {
  return cdf(complement(ChiSquared(freedom), x));
}

double fisher_f_quantile(double p, double freedom_1, double freedom_2) {
  return quantile(FisherF(freedom_1, freedom_2), p);
}

double fisher_f_survival(double x, double freedom_1, double freedom_2) {
  return cdf(complement(FisherF(freedom_1, freedom_2), x));
}

double binomial_cdf(double successes, double n, double rate) {
  return cdf(Binomial(n, rate), successes);
}

double binomial_survival(double successes, double n, double rate) {
  return cdf(complement(Binomial(n, rate), successes));
}

double binomial_lower_bound(double successes, double n, double tail) {
  return Binomial::find_lower_bound_on_p(n, successes, tail);
}

double binomial_upper_bound(double successes, double n, double tail) {
  return Binomial::find_upper_bound_on_p(n, successes, tail);
}

double find_root(const std::function<double(double)>& f, double low, double high) {
  std::uintmax_t max_iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      f, low, high, boost::math::tools::eps_tolerance<double>(44), max_iterations);
  return (bracket.first + bracket.second) / 2;
}

}  // namespace slalom::distributions
