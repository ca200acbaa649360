// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"

#include <slalom/core/math.h>

#include <cmath>

namespace slalom::metrics {
namespace {

/// Sum of the changes between samples. Imported logs may have no commands: NaN.
template <typename Change>
Value sum_of_changes(const MetricContext& context, Change change) {
  if (const auto na = na_without_time(context)) return *na;
  const auto& samples = context.trajectory.samples;
  double sum = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) sum += change(samples[i - 1], samples[i]);
  return std::isfinite(sum) ? Value::of(sum) : Value::na("no commands are recorded");
}

}  // namespace

/// Sum of |change of the commanded linear velocity|.
Value command_variation_v(const MetricContext& context) {
  return sum_of_changes(context, [](const Sample& a, const Sample& b) {
    return math::hypot(b.command_v - a.command_v, b.command_vy - a.command_vy);
  });
}

/// Sum of |change of the commanded angular velocity|.
Value command_variation_w(const MetricContext& context) {
  return sum_of_changes(context, [](const Sample& a, const Sample& b) {
    return std::abs(b.command_w - a.command_w);
  });
}

/// Number of sign changes of the angular velocity, ignoring values up to 0.1 rad/s.
Value oscillation_count(const MetricContext& context) {
  constexpr double kMinTurnRate = 0.1;  // rad/s
  if (const auto na = na_without_time(context)) return *na;
  int changes = 0, side = 0;
  for (const Sample& sample : context.trajectory.samples) {
    if (std::abs(sample.w) <= kMinTurnRate) continue;
    const int now = sample.w > 0 ? 1 : -1;
    if (side != 0 && now != side) ++changes;
    side = now;
  }
  return Value::of(changes);
}

}  // namespace slalom::metrics
