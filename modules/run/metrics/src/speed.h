// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/metrics/metric.h>

#include <vector>

namespace slalom {

/// Velocities over time.
struct SpeedProfile {
  std::vector<double> t;  ///< s, strictly increasing
  std::vector<double> v;  ///< m/s, forward; magnitude for robots with lateral motion
  std::vector<double> w;  ///< rad/s, angular velocity
};

/// The velocities of a trajectory.
SpeedProfile speed_profile(const MetricContext& context);

/// The duration (s) that each sample represents: half of the intervals before and after it. The sum
/// is the duration of the trajectory.
std::vector<double> sample_weights(const std::vector<double>& t);

/// The median interval (s); requires at least two times.
double median_interval(const std::vector<double>& t);

/// Removes samples less than a quarter of the median interval after the previous one. A run may end
/// at any time; differences over a very short interval would amplify rounding errors.
SpeedProfile without_short_intervals(const SpeedProfile& profile);

}  // namespace slalom
