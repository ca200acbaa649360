// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "mover_encounters.h"
#include "speed.h"

#include <algorithm>
#include <cmath>

namespace slalom::metrics {
namespace {

/// Time stopped, of the samples for which `counts` is true.
template <typename Counts>
Value stopped_time(const MetricContext& context, Counts counts) {
  constexpr double kMinLinear = 0.01;   // m/s
  constexpr double kMinAngular = 0.02;  // rad/s
  if (const auto na = na_without_time(context)) return *na;
  const SpeedProfile speeds = speed_profile(context);
  const std::vector<double> weights = sample_weights(speeds.t);
  double stopped = 0;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (std::abs(speeds.v[i]) < kMinLinear && std::abs(speeds.w[i]) < kMinAngular &&
        counts(context.trajectory.samples[i]))
      stopped += weights[i];
  return Value::of(stopped);
}

}  // namespace

/// L / T.
Value mean_speed(const MetricContext& context) {
  if (const auto na = na_without_time(context)) return *na;
  return Value::of(context.trajectory.traveled() / context.trajectory.duration());
}

/// Time with |v| < 0.01 m/s and |w| < 0.02 rad/s.
Value time_stopped(const MetricContext& context) {
  return stopped_time(context, [](const Sample&) { return true; });
}

/// Time stopped while a mover is near, within the social distance of E. T. Hall, The Hidden
/// Dimension, 1966: 12 feet.
Value frozen_time(const MetricContext& context) {
  constexpr double kSocialDistance = 3.6;  // m
  if (const auto na = na_without_movers(context)) return *na;
  return stopped_time(context, [&](const Sample& sample) {
    const double t = run_time(context, sample);
    return std::any_of(context.movers.begin(), context.movers.end(), [&](const Mover& mover) {
      const double gap =
          distance_between(mover.position(t), sample.pose) - reach_of(context, mover);
      return mover.present(t) && gap < kSocialDistance;
    });
  });
}

}  // namespace slalom::metrics
