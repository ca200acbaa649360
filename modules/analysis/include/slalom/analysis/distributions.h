// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

/// Boost's distributions, computed in double on all processors. By default Boost computes in long
/// double, which has 64 digits (of base 2) on x86-64 and 113, in software, on arm64.
namespace slalom::distributions {

using Double = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

using Binomial = boost::math::binomial_distribution<double, Double>;
using ChiSquared = boost::math::chi_squared_distribution<double, Double>;
using FisherF = boost::math::fisher_f_distribution<double, Double>;
using NonCentralT = boost::math::non_central_t_distribution<double, Double>;
using Normal = boost::math::normal_distribution<double, Double>;
using StudentsT = boost::math::students_t_distribution<double, Double>;

}  // namespace slalom::distributions
