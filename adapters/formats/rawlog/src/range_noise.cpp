// SPDX-License-Identifier: BSD-3-Clause
#include "range_noise.h"

#include <slalom/statistics/distributions.h>
#include <slalom/statistics/statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

using mrpt::obs::CObservation2DRangeScan;

constexpr std::size_t kMinScans = 20;
constexpr double kNoReturn = std::numeric_limits<double>::infinity();

bool is_stationary(const LoggedVelocity& velocity) {
  return std::abs(velocity.v) < 0.01 && std::abs(velocity.w) < 0.02;
}

/// The scans of the longest phase, by their number, in which the robot is stationary.
std::vector<TimedScan> stationary_scans(const MotionLog& log) {
  const auto earlier = [](const TimedScan& scan, double time) { return scan.time < time; };
  auto begin = log.scans.end(), end = log.scans.end();
  const auto& velocities = log.odometry;
  for (std::size_t first = 0, next = 0; first < velocities.size(); first = next + 1) {
    for (next = first; next < velocities.size() && is_stationary(velocities[next]);) ++next;
    if (next == first) continue;
    constexpr double kSameInstant = 1e-6;  // s
    const auto from = std::lower_bound(log.scans.begin(), log.scans.end(),
                                       velocities[first].time - kSameInstant, earlier);
    const auto to =
        std::lower_bound(from, log.scans.end(), velocities[next - 1].time + kSameInstant, earlier);
    if (to - from <= end - begin) continue;
    begin = from;
    end = to;
  }
  return {begin, end};
}

double range_of(const CObservation2DRangeScan& scan, std::size_t ray) {
  const double range = scan.getScanRange(ray);
  const bool is_valid = scan.getScanRangeValidity(ray) && range > 0 && range < scan.maxRange;
  return is_valid ? range : kNoReturn;
}

/// The readings of a ray, m.
struct Ray {
  double median = 0;
  std::vector<double> ranges;
};

/// The rays whose median is valid.
std::vector<Ray> valid_rays(const std::vector<TimedScan>& scans) {
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < scans.front().scan->getScanSize(); ++i) {
    Ray ray;
    for (const TimedScan& scan : scans) ray.ranges.push_back(range_of(*scan.scan, i));
    auto middle = ray.ranges;
    // The lower one of two medians: the mean of a range and none would be none.
    const auto at = middle.begin() + static_cast<long>((middle.size() - 1) / 2);
    std::nth_element(middle.begin(), at, middle.end());
    ray.median = *at;
    if (std::isfinite(ray.median)) rays.push_back(std::move(ray));
  }
  return rays;
}

/// The greatest step of which all ranges are multiples within 1e-4 m. 0 if there is none of at
/// least 1e-3 m, since every range is close to a multiple of a smaller one, or if there are few
/// different ranges, which have common divisors by chance.
double find_quantum(const std::vector<Ray>& rays) {
  constexpr double kTolerance = 1e-4, kMinQuantum = 1e-3;  // m
  constexpr int kMinDifferences = 10;
  std::vector<double> ranges;
  for (const Ray& ray : rays)
    for (const double range : ray.ranges)
      if (std::isfinite(range)) ranges.push_back(range);
  std::sort(ranges.begin(), ranges.end());
  // A quantum divides the smallest difference.
  double difference = ranges.front();
  int differences = 0;
  for (std::size_t i = 1; i < ranges.size(); ++i)
    if (ranges[i] - ranges[i - 1] > 2 * kTolerance) {
      difference = std::min(difference, ranges[i] - ranges[i - 1]);
      ++differences;
    }
  if (differences < kMinDifferences) return 0;
  for (int divisor = 1; difference / divisor > kMinQuantum - kTolerance; ++divisor) {
    double quantum = difference / divisor;
    const bool divides = std::all_of(ranges.begin(), ranges.end(), [&](double range) {
      const double multiple = std::round(range / quantum);
      if (multiple < 1 || std::abs(range - multiple * quantum) > kTolerance) return false;
      quantum = range / multiple;  // its error would grow with the multiples
      return true;
    });
    if (divides) return quantum;
  }
  return 0;
}

/// Five deviations, estimated by the median of their absolute values, which is 0 if the noise is
/// below the quantum.
double outlier_threshold(const std::vector<Ray>& rays, double quantum) {
  constexpr double kDeviations = 5, kSigmaPerMedian = 1.4826;  // of a normal distribution
  std::vector<double> deviations;
  for (const Ray& ray : rays)
    for (const double range : ray.ranges)
      if (std::isfinite(range)) deviations.push_back(std::abs(range - ray.median));
  return std::max(kDeviations * kSigmaPerMedian * median(std::move(deviations)), 2 * quantum) +
         1e-6;
}

/// The standard deviation of ranges before they are rounded.
double noise_of(double variance, double quantum) {
  return std::sqrt(std::max(0.0, variance - quantum * quantum / 12));
}

Interval sigma_interval(double squares, double freedom, double quantum, double confidence) {
  const auto bound = [&](double fraction) {
    return noise_of(squares / distributions::chi_squared_quantile(fraction, freedom), quantum);
  };
  const double tail = 0.5 * (1 - confidence);
  Interval interval = {bound(1 - tail), bound(tail)};
  if (noise_of(squares / freedom, quantum) < 0.5 * quantum)
    interval = {0, std::max(interval.high, 0.5 * quantum)};
  return interval;
}

}  // namespace

RangeNoise estimate_range_noise(const MotionLog& log, double confidence) {
  RangeNoise noise;
  const std::vector<TimedScan> scans = stationary_scans(log);
  if (scans.size() < kMinScans) {
    noise.problem = "the robot is stationary for at most " + std::to_string(scans.size()) +
                    " scans; expected " + std::to_string(kMinScans);
    return noise;
  }
  std::vector<Ray> rays = valid_rays(scans);
  if (rays.empty()) {
    noise.problem = "no ray returns while the robot is stationary";
    return noise;
  }
  noise.quantum = find_quantum(rays);
  const double threshold = outlier_threshold(rays, noise.quantum);
  const double max_range = scans.front().scan->maxRange;
  double squares = 0, freedom = 0, dropouts = 0;
  for (const Ray& ray : rays) {
    // Noise beyond the maximum range is no return.
    if (ray.median + threshold > max_range) continue;
    double n = 0, sum = 0, sum_of_squares = 0;  // of the deviations, without outliers
    for (const double range : ray.ranges) {
      if (!std::isfinite(range)) ++dropouts;
      const double deviation = range - ray.median;
      if (std::abs(deviation) > threshold) continue;
      ++n;
      sum += deviation;
      sum_of_squares += deviation * deviation;
    }
    noise.ranges += ray.ranges.size();
    squares += sum_of_squares - sum * sum / n;
    freedom += n - 1;
  }
  if (noise.ranges == 0) {
    noise.problem = "all ranges are close to the maximum while the robot is stationary";
    return noise;
  }
  noise.sigma = noise_of(squares / freedom, noise.quantum);
  noise.sigma_interval = sigma_interval(squares, freedom, noise.quantum, confidence);
  noise.dropout_ratio = dropouts / static_cast<double>(noise.ranges);
  noise.dropout_interval =
      clopper_pearson_interval(dropouts, static_cast<double>(noise.ranges), confidence);
  return noise;
}

}  // namespace slalom
