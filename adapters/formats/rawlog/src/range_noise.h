// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/rawlog/motion_log.h>
#include <slalom/statistics/statistics.h>

namespace slalom {

/// The noise of a range sensor that does not move.
struct RangeNoise {
  std::string problem;  ///< why there is no estimate; "" otherwise
  double sigma = 0;     ///< m
  double dropout_ratio = 0;
  Interval sigma_interval, dropout_interval;
  double quantum = 0;      ///< m, 0: ranges are not rounded
  std::size_t ranges = 0;  ///< of rays whose median is valid
};

/// Estimates the noise of the scans in the longest phase in which the measured velocity stays below
/// 0.01 m/s and 0.02 rad/s. `sigma` is the standard deviation of each ray, pooled over the rays
/// whose median is valid. It excludes ranges more than five deviations from the median, which
/// belong to other objects, and the variance quantum^2/12 of rounding (B. Widrow, I. Kollar,
/// "Quantization Noise", 2008). Rounding has that variance only if the noise exceeds half a
/// quantum; otherwise the interval of `sigma` ends there. Dropouts count as independent of each
/// other.
RangeNoise estimate_range_noise(const MotionLog& log, double confidence);

}  // namespace slalom
