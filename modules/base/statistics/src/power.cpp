// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/power.h>

#include <cmath>

namespace slalom {
namespace {

constexpr std::size_t kMaxSize = 10000000;
constexpr double kCertain = 10000;  ///< standard errors; limit of Boost's noncentral t

}  // namespace

double paired_t_power(double n, double relevant, double deviation, double alpha) {
  if (n < 2) return 0;
  const double degrees = n - 1, shift = relevant / deviation * std::sqrt(n);
  if (shift > kCertain) return 1;
  const double t = distributions::students_t_quantile(1 - alpha / 2, degrees);
  return distributions::noncentral_t_outside(t, degrees, shift);
}

std::size_t required_pairs(double relevant, double deviation, double alpha, double power) {
  const auto enough = [&](std::size_t n) {
    return paired_t_power(static_cast<double>(n), relevant, deviation, alpha) >= power;
  };
  std::size_t high = 2;
  while (!enough(high)) {
    if (high >= kMaxSize) return kMaxSize;
    high *= 2;
  }
  std::size_t low = high / 2;  // not enough, or 1
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (enough(middle) ? high : low) = middle;
  }
  return high;
}

std::size_t min_pairs(double alpha) {
  std::size_t n = 1;
  for (double p = 1; p > alpha && n < 100; p /= 2) ++n;
  return n;
}

}  // namespace slalom
