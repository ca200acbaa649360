#pragma once

#include <slalom/metrics/metric.h>

#include <vector>

namespace slalom {

/// Speeds over time.
struct SpeedProfile {
  std::vector<double> t;  ///< s, strictly increasing
  std::vector<double> v;  ///< m/s: ahead, or of a robot that moves sideways the velocity's length
  std::vector<double> w;  ///< rad/s
};

/// The speeds of a trajectory.
SpeedProfile speed_profile(const MetricContext& context);

/// The seconds that each sample stands for: half of the intervals before and after it. They add up
/// to the duration, so that what goes on when the log ends is counted to its end.
std::vector<double> sample_weights(const std::vector<double>& t);

/// The median interval (s); requires two times or more.
double median_interval(const std::vector<double>& t);

/// Without samples that follow the one before after less than a quarter of the median interval. A
/// run ends at any instant; differences over so short an interval would magnify its rounding.
SpeedProfile without_short_intervals(const SpeedProfile& profile);

}  // namespace slalom
