#include "common.h"
#include "speed.h"

namespace slalom::metrics {

/// L / T.
Value mean_speed(const MetricContext& context) {
  if (const auto na = na_without_time(context)) return *na;
  return Value::of(context.trajectory.traveled() / context.trajectory.duration());
}

/// Time with |v| < 0.01 m/s and |w| < 0.02 rad/s.
Value time_stopped(const MetricContext& context) {
  constexpr double kMinLinear = 0.01;   // m/s
  constexpr double kMinAngular = 0.02;  // rad/s
  if (const auto na = na_without_time(context)) return *na;
  const SpeedProfile speeds = speed_profile(context);
  const std::vector<double> weights = sample_weights(speeds.t);
  double stopped = 0;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (std::abs(speeds.v[i]) < kMinLinear && std::abs(speeds.w[i]) < kMinAngular)
      stopped += weights[i];
  return Value::of(stopped);
}

}  // namespace slalom::metrics
