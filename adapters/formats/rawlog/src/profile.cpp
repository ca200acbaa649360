// SPDX-License-Identifier: BSD-3-Clause
#include "profile.h"

#include <slalom/statistics/distributions.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// The distance from `best` to `end` at which the deviance exceeds the bound, at most 1/64 too far.
double distance(const Profile& profile, double bound, double end) {
  constexpr double kFirstStep = 1e-4;  // s, or without unit
  constexpr int kBisections = 6;
  const double longest = std::abs(end - profile.best);
  const double direction = end > profile.best ? 1 : -1;
  const auto is_within = [&](double step) {
    return profile.deviance(profile.best + direction * step) <= bound;
  };
  double low = 0, high = kFirstStep;
  while (high < longest && is_within(high)) {
    low = high;
    high *= 2;
  }
  if (high >= longest) {
    if (is_within(longest)) return longest;
    high = longest;
  }
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (is_within(middle) ? low : high) = middle;
  }
  return high;
}

}  // namespace

Profile pooled(const Profile& a, const Profile& b) {
  constexpr double kMinStride = 1e-5;  // s
  Profile both;
  both.lowest = std::max(a.lowest, b.lowest);
  both.highest = std::min(a.highest, b.highest);
  both.freedom = a.freedom + b.freedom;
  both.deviance = [a, b](double value) { return a.deviance(value) + b.deviance(value); };
  double at_a = both.deviance(a.best), at_b = both.deviance(b.best);
  both.best = at_a <= at_b ? a.best : b.best;
  double least = std::min(at_a, at_b);
  for (double stride = 0.5 * std::abs(a.best - b.best); stride > kMinStride; stride *= 0.5)
    for (const double direction : {-1, 1}) {
      const double value = std::clamp(both.best + direction * stride, both.lowest, both.highest);
      const double deviance = both.deviance(value);
      if (deviance >= least) continue;
      least = deviance;
      both.best = value;
      break;
    }
  return both;
}

Interval profile_interval(const Profile& profile, double confidence) {
  const double bound = profile.deviance(profile.best) +
                       distributions::fisher_f_quantile(confidence, 1, profile.freedom);
  return {profile.best - distance(profile, bound, profile.lowest),
          profile.best + distance(profile, bound, profile.highest)};
}

}  // namespace slalom
