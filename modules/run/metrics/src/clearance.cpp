// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"

#include <algorithm>

namespace slalom::metrics {
namespace {

/// Fraction of an interval in which a clearance, linear between its ends, is below `limit`.
double fraction_below(double a, double b, double limit) {
  if (a >= limit && b >= limit) return 0;
  if (a < limit && b < limit) return 1;
  return (limit - std::min(a, b)) / std::abs(a - b);
}

}  // namespace

/// Minimum clearance of the footprint over the samples.
Value min_clearance(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return *na;
  return Value::of(*std::min_element(context.clearances.begin(), context.clearances.end()));
}

/// Mean clearance of the footprint, weighted by the path length between samples.
Value mean_clearance(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return *na;
  const Path path = context.trajectory.path();
  double sum = 0, total = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double piece = length({path[i - 1], path[i]});
    sum += 0.5 * (context.clearances[i - 1] + context.clearances[i]) * piece;
    total += piece;
  }
  if (total <= 0) return Value::na("the robot did not move");
  return Value::of(sum / total);
}

/// Fraction of time with a clearance below `safe_distance`; clearance is linear between samples.
Value risk_time_ratio(const MetricContext& context) {
  if (const auto na = na_without_time(context)) return *na;
  const auto& samples = context.trajectory.samples;
  double at_risk = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    at_risk +=
        (samples[i].t - samples[i - 1].t) *
        fraction_below(context.clearances[i - 1], context.clearances[i], context.safe_distance);
  return Value::of(at_risk / context.trajectory.duration());
}

/// Mean over time of 1 / max(d_i, 1 cm).
Value inverse_clearance(const MetricContext& context) {
  constexpr double kMinClearance = 0.01;  // m
  if (const auto na = na_without_time(context)) return *na;
  const auto& samples = context.trajectory.samples;
  const auto inverse = [&](std::size_t i) {
    return 1 / std::max(context.clearances[i], kMinClearance);
  };
  double sum = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    sum += 0.5 * (inverse(i - 1) + inverse(i)) * (samples[i].t - samples[i - 1].t);
  return Value::of(sum / context.trajectory.duration());
}

}  // namespace slalom::metrics
