// SPDX-License-Identifier: BSD-3-Clause
#include "speed.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

bool moves_sideways(const MetricContext& context) {
  const auto& samples = context.trajectory.samples;
  return context.robot.holonomic() ||
         std::any_of(samples.begin(), samples.end(), [](const Sample& s) { return s.vy != 0; });
}

}  // namespace

SpeedProfile speed_profile(const MetricContext& context) {
  const bool sideways = moves_sideways(context);
  SpeedProfile profile;
  for (const Sample& sample : context.trajectory.samples) {
    profile.t.push_back(sample.t);
    profile.v.push_back(sideways ? math::hypot(sample.v, sample.vy) : sample.v);
    profile.w.push_back(sample.w);
  }
  return profile;
}

std::vector<double> sample_weights(const std::vector<double>& t) {
  std::vector<double> weights(t.size(), 0.0);
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double half = 0.5 * (t[i] - t[i - 1]);
    weights[i - 1] += half;
    weights[i] += half;
  }
  return weights;
}

double median_interval(const std::vector<double>& t) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < t.size(); ++i) intervals.push_back(t[i] - t[i - 1]);
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

SpeedProfile without_short_intervals(const SpeedProfile& profile) {
  if (profile.t.size() < 3) return profile;
  const double shortest = 0.25 * median_interval(profile.t);
  SpeedProfile kept;
  for (std::size_t i = 0; i < profile.t.size(); ++i) {
    if (i > 0 && profile.t[i] - kept.t.back() < shortest) continue;
    kept.t.push_back(profile.t[i]);
    kept.v.push_back(profile.v[i]);
    kept.w.push_back(profile.w[i]);
  }
  return kept;
}

}  // namespace slalom
